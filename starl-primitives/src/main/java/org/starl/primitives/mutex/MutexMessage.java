package org.starl.primitives.mutex;

import static org.starl.shape.Shapes.PROCESS;
import static org.starl.shape.Shapes.part;

import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.Sections;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.SumShape;

/** Messages of a mutex. Each may be lost, late, duplicated or reordered. */
sealed interface MutexMessage {

  /** The limit of datagram headers: a received time must not make a clock overflow. */
  long MAX_TS = (1L << 62) - 1;

  /** What is requested. */
  enum Kind {
    /** Sections that are granted at once. */
    SET,
    /** Sections that are granted one by one. */
    SEQUENCE,
    /** The rest of a sequence, all of it taken over from the robot's earlier processes. */
    RESUMED
  }

  /**
   * The sections of a request.
   *
   * @param waits at least one: these need consent
   * @param holds which it has: of a sequence, when the request is repeated, or asks a newcomer; of a
   *     resumed one, also those with a capacity that it asks for and its body is in, as many as fit
   */
  record Wish(Kind kind, SortedSet<String> waits, SortedSet<String> holds) {
    public Wish {
      if (waits.isEmpty()) {
        throw new IllegalArgumentException("request without sections");
      }
    }

    private static final Shape<Wish> SHAPE =
        Shapes.of(
            Wish.class,
            part("kind", Shapes.constant(Kind.class), Wish::kind),
            part("holds", Sections.SHAPE, Wish::holds),
            part("waits", Sections.SHAPE, Wish::waits),
            (kind, holds, waits) -> new Wish(kind, waits, holds));
  }

  ProcessId from();

  /** The addressed participant: a robot may also answer under an older id. */
  ProcessId to();

  /**
   * {@code from} requests {@code wish}. Repeated until the {@link Ok} arrives or the request ends.
   *
   * @param num the request's number, from 1; an id never uses a number twice
   * @param admittedBy the number of the view that admitted {@code from}
   * @param ts the request's logical time; the lower one goes first
   */
  record Req(ProcessId from, ProcessId to, long num, long admittedBy, long ts, Wish wish)
      implements MutexMessage {

    /** For a set. */
    Req(ProcessId from, ProcessId to, long num, long admittedBy, long ts, SortedSet<String> want) {
      this(from, to, num, admittedBy, ts, new Wish(Kind.SET, want, Sections.NONE));
    }

    /** What it waits for: this needs consent. */
    SortedSet<String> waits() {
      return wish.waits;
    }

    /** What it holds, or waits for. */
    SortedSet<String> want() {
      return wish.holds.isEmpty() ? wish.waits : Sections.union(wish.waits, wish.holds);
    }

    /** Whether it takes consent to a part. */
    boolean inOrder() {
      return wish.kind != Kind.SET;
    }

    boolean resumes() {
      return wish.kind == Kind.RESUMED;
    }

    /** Whether the sender's body is in {@code section} since an earlier process entered it. */
    boolean isInside(String section) {
      return resumes() && wish.holds.contains(section);
    }

    public Req {
      requireOther(from, to);
    }
  }

  /**
   * {@code from} consents to request {@code num} of {@code to}, and to no other request.
   *
   * @param part the sections to which it consents, with those of earlier answers
   * @param counted others to which it consents, but of which {@code from} takes a place itself until a
   *     later answer: it is one of the robots that their capacity limits. Both empty: all
   */
  record Ok(
      ProcessId from, ProcessId to, long num, SortedSet<String> part, SortedSet<String> counted)
      implements MutexMessage {
    public Ok {
      requireOther(from, to);
    }

    /** All to which it consents, without a place of its own or with one. */
    SortedSet<String> granted(SortedSet<String> want) {
      return isWhole() ? want : Sections.union(part, counted);
    }

    /** Whether it is a consent to all of the request, without a place of its own. */
    boolean isWhole() {
      return part.isEmpty() && counted.isEmpty();
    }

    /** To a part. */
    Ok(ProcessId from, ProcessId to, long num, SortedSet<String> part) {
      this(from, to, num, part, Sections.NONE);
    }

    /** To all of it. */
    Ok(ProcessId from, ProcessId to, long num) {
      this(from, to, num, Sections.NONE);
    }
  }

  /** The sections of request {@code num} that {@code from} still holds or wants; none: it ended. */
  record Rem(ProcessId from, ProcessId to, long num, SortedSet<String> left)
      implements MutexMessage {
    public Rem {
      requireOther(from, to);
    }
  }

  /**
   * {@code from} is alive, and defers its answer to request {@code num} of {@code to}. Sent when
   * the request is repeated.
   *
   * @param ahead the number of the request of {@code from} that comes first, since it waits, and {@code from}
   *     holds a section of request {@code num}, or stands there; 0 for none
   */
  record Noted(ProcessId from, ProcessId to, long num, long ahead) implements MutexMessage {
    public Noted {
      requireOther(from, to);
    }

    /** Not ahead. */
    Noted(ProcessId from, ProcessId to, long num) {
      this(from, to, num, 0);
    }
  }

  /**
   * {@code from} suspects that {@code suspect} has crashed.
   *
   * @param admittedBy the number of the view that admitted {@code suspect}
   */
  record FenceQ(ProcessId from, ProcessId to, ProcessId suspect, long admittedBy)
      implements MutexMessage {
    public FenceQ {
      requireOther(from, to);
      requireOther(from, suspect);
    }
  }

  /**
   * {@code from} never grants {@code suspect} anything again. {@code suspect} needs its consent,
   * and so holds at most {@code open}.
   */
  record Fence(ProcessId from, ProcessId to, ProcessId suspect, SortedSet<String> open)
      implements MutexMessage {
    public Fence {
      requireOther(from, to);
      requireOther(from, suspect);
    }
  }

  /** {@code from} has fenced {@code to}, which should register again. */
  record Fenced(ProcessId from, ProcessId to) implements MutexMessage {
    public Fenced {
      requireOther(from, to);
    }
  }

  private static void requireOther(ProcessId from, ProcessId other) {
    if (from.equals(other)) {
      throw new IllegalArgumentException("a message of " + from + " to or about itself");
    }
  }

  /** The shapes of all messages. */
  SumShape<MutexMessage> SHAPE = shape();

  private static SumShape<MutexMessage> shape() {
    Shape<Long> num = Shapes.atLeast(1, "request number");
    Shape<Long> admittedBy = Shapes.atLeast(1, "view number");
    return Shapes.oneOf(
        MutexMessage.class,
        Shapes.of(
            Req.class,
            part("from", PROCESS, Req::from),
            part("to", PROCESS, Req::to),
            part("num", num, Req::num),
            part("admittedBy", admittedBy, Req::admittedBy),
            part("ts", Shapes.within(1, MAX_TS, "logical time"), Req::ts),
            part("wish", Wish.SHAPE, Req::wish),
            Req::new),
        Shapes.of(
            Ok.class,
            part("from", PROCESS, Ok::from),
            part("to", PROCESS, Ok::to),
            part("num", num, Ok::num),
            part("part", Sections.SHAPE, Ok::part),
            part("counted", Sections.SHAPE, Ok::counted),
            Ok::new),
        Shapes.of(
            Rem.class,
            part("from", PROCESS, Rem::from),
            part("to", PROCESS, Rem::to),
            part("num", num, Rem::num),
            part("left", Sections.SHAPE, Rem::left),
            Rem::new),
        Shapes.of(
            Noted.class,
            part("from", PROCESS, Noted::from),
            part("to", PROCESS, Noted::to),
            part("num", num, Noted::num),
            part("ahead", Shapes.atLeast(0, "request number"), Noted::ahead),
            Noted::new),
        Shapes.of(
            FenceQ.class,
            part("from", PROCESS, FenceQ::from),
            part("to", PROCESS, FenceQ::to),
            part("suspect", PROCESS, FenceQ::suspect),
            part("admittedBy", admittedBy, FenceQ::admittedBy),
            FenceQ::new),
        Shapes.of(
            Fence.class,
            part("from", PROCESS, Fence::from),
            part("to", PROCESS, Fence::to),
            part("suspect", PROCESS, Fence::suspect),
            part("open", Sections.SHAPE, Fence::open),
            Fence::new),
        Shapes.of(
            Fenced.class,
            part("from", PROCESS, Fenced::from),
            part("to", PROCESS, Fenced::to),
            Fenced::new));
  }
}
