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

  ProcessId from();

  /** The addressed participant: a robot may also answer under an older id. */
  ProcessId to();

  /**
   * {@code from} requests {@code want}. Repeated until the {@link Ok} arrives or the request ends.
   *
   * @param num the request's number, from 1; an id never uses a number twice
   * @param admittedBy the number of the view that admitted {@code from}
   * @param ts the request's logical time; the lower one goes first
   */
  record Req(
      ProcessId from, ProcessId to, long num, long admittedBy, long ts, SortedSet<String> want)
      implements MutexMessage {
    public Req {
      requireOther(from, to);
      if (want.isEmpty()) {
        throw new IllegalArgumentException("request without sections");
      }
    }
  }

  /** {@code from} grants request {@code num} of {@code to}, and no other request. */
  record Ok(ProcessId from, ProcessId to, long num) implements MutexMessage {
    public Ok {
      requireOther(from, to);
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
   */
  record Noted(ProcessId from, ProcessId to, long num) implements MutexMessage {
    public Noted {
      requireOther(from, to);
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
            part("want", Sections.SHAPE, Req::want),
            Req::new),
        Shapes.of(
            Ok.class,
            part("from", PROCESS, Ok::from),
            part("to", PROCESS, Ok::to),
            part("num", num, Ok::num),
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
