package org.starl.primitives.mutex;

import static org.starl.shape.Shapes.LONG;
import static org.starl.shape.Shapes.PROCESS;
import static org.starl.shape.Shapes.part;

import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.primitives.Phases;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexProtocol.Phase;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.SumShape;
import org.starl.trace.Holding;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;

/** What a trace tells of a mutex: its actions, and the variables that an app reads. */
public sealed interface MutexFact {

  /** The primitive's name in sources. */
  String PRIMITIVE = "mutex";

  /** The paper's {@code crit}: whether the robot holds a section. */
  Var<Boolean> CRIT = Var.of("crit", Shapes.BOOL);

  /** The paper's {@code failed}: whether the latest request ended without access. */
  Var<Boolean> FAILED = Var.of("failed", Shapes.BOOL);

  /** Why the latest request failed. */
  Var<MutexFailure> FAILURE = Var.of("failure", MutexFailure.class);

  /** The participant that took the step. */
  ProcessId who();

  /** The action of the theory that this is, if it is one: the theory has no agreement protocol. */
  default Optional<MutexAction> action() {
    ProcessId i = MutexConformance.process(who().robot());
    return Optional.ofNullable(
        switch (this) {
          case DoMutex f -> new MutexAction.do_mutex(i, f.want);
          case OdMutex f -> new MutexAction.od_mutex(i, f.held);
          case Release f -> new MutexAction.release(i, f.given);
          case Withdraw f -> f.num == 0 ? null : new MutexAction.withdraw(i);
          case StandsIn f -> new MutexAction.stands_in(i, f.sections);
          case Grant f -> null;
          case Known f -> null;
          case Learned f -> null;
          case Fence f -> null;
        });
  }

  /**
   * A request begins. A program that resumes may make it anew, with a later time, while it holds a part.
   *
   * @param num the number of the request, counted for each {@code who}
   * @param ts the logical time of the request
   * @param want what it holds or waits for
   * @param sequence what it waits for, in the order of the grants; empty for a set, granted at once
   * @param resumes whether it takes {@code want} over from the robot's earlier processes
   * @param known the participants whose consent it needs
   */
  record DoMutex(
      ProcessId who,
      long num,
      long ts,
      SortedSet<String> want,
      List<String> sequence,
      boolean resumes,
      SortedSet<ProcessId> known)
      implements MutexFact, Holding {

    @Override
    public String holding() {
      return "waits for " + (sequence.isEmpty() ? want : sequence);
    }

    public DoMutex {
      sequence = List.copyOf(sequence);
    }

    /** For a set. */
    public DoMutex(
        ProcessId who, long num, long ts, SortedSet<String> want, SortedSet<ProcessId> known) {
      this(who, num, ts, want, List.of(), false, known);
    }
  }

  /** Access was granted: it now holds {@code held}. */
  record OdMutex(ProcessId who, long num, SortedSet<String> held) implements MutexFact, Holding {
    @Override
    public String holding() {
      return "holds " + held;
    }
  }

  /** {@code given} was released, {@code left} is still held. */
  record Release(ProcessId who, long num, SortedSet<String> given, SortedSet<String> left)
      implements MutexFact, Holding {
    @Override
    public String holding() {
      return left.isEmpty() ? "" : "holds " + left;
    }
  }

  /**
   * The request ended without access.
   *
   * @param num the number of the request; 0 if it never began, which is no action of the theory
   */
  record Withdraw(ProcessId who, long num, MutexFailure why) implements MutexFact, Holding {
    @Override
    public String holding() {
      return "";
    }
  }

  /**
   * {@code who} consents to request {@code num} of {@code to}.
   *
   * @param part the sections to which it consents from now on; empty for all
   */
  record Grant(ProcessId who, ProcessId to, long num, SortedSet<String> part) implements MutexFact {

    /** To all of it. */
    public Grant(ProcessId who, ProcessId to, long num) {
      this(who, to, num, Sections.NONE);
    }

    /** The sections to which it consents, of a request for {@code want}. */
    SortedSet<String> granted(SortedSet<String> want) {
      return part.isEmpty() ? want : part;
    }
  }

  /** From now on a request needs, or would need, the consent of {@code known}. */
  record Known(ProcessId who, long num, SortedSet<ProcessId> known) implements MutexFact {}

  /** {@code who} has learned {@code view}. */
  record Learned(ProcessId who, View view) implements MutexFact {}

  /**
   * {@code who} never grants {@code suspect} anything again.
   *
   * @param open the sections that {@code who} has granted and {@code suspect} may still hold
   */
  record Fence(ProcessId who, ProcessId suspect, SortedSet<String> open) implements MutexFact {}

  /**
   * The robot of {@code who} declares, after a restart of its program, that its body is only in
   * these sections. Its participants of earlier starts are dead.
   */
  record StandsIn(ProcessId who, SortedSet<String> sections) implements MutexFact {}

  /** The shapes of all facts, under the names of the paper and the theory. */
  SumShape<MutexFact> SHAPE = shape();

  private static SumShape<MutexFact> shape() {
    Shape<SortedSet<String>> sections = Sections.SHAPE;
    Shape<SortedSet<ProcessId>> processes = View.PROCESSES;
    return Shapes.oneOf(
        MutexFact.class,
        Shapes.of(
                DoMutex.class,
                part("who", PROCESS, DoMutex::who),
                part("num", LONG, DoMutex::num),
                part("ts", LONG, DoMutex::ts),
                part("want", sections, DoMutex::want),
                part("sequence", Shapes.list(Shapes.TEXT, Sections.MAX_COUNT), DoMutex::sequence),
                part("resumes", Shapes.BOOL, DoMutex::resumes),
                part("known", processes, DoMutex::known),
                DoMutex::new)
            .named("do_mutex"),
        Shapes.of(
                OdMutex.class,
                part("who", PROCESS, OdMutex::who),
                part("num", LONG, OdMutex::num),
                part("held", sections, OdMutex::held),
                OdMutex::new)
            .named("od_mutex"),
        Shapes.of(
                Release.class,
                part("who", PROCESS, Release::who),
                part("num", LONG, Release::num),
                part("given", sections, Release::given),
                part("left", sections, Release::left),
                Release::new)
            .named("release"),
        Shapes.of(
                Withdraw.class,
                part("who", PROCESS, Withdraw::who),
                part("num", LONG, Withdraw::num),
                part("why", FAILURE.shape(), Withdraw::why),
                Withdraw::new)
            .named("withdraw"),
        Shapes.of(
                Grant.class,
                part("who", PROCESS, Grant::who),
                part("to", PROCESS, Grant::to),
                part("num", LONG, Grant::num),
                part("part", sections, Grant::part),
                Grant::new)
            .named("grant"),
        Shapes.of(
                Known.class,
                part("who", PROCESS, Known::who),
                part("num", LONG, Known::num),
                part("known", processes, Known::known),
                Known::new)
            .named("known"),
        Shapes.of(
                Learned.class,
                part("who", PROCESS, Learned::who),
                part("view", View.SHAPE, Learned::view),
                Learned::new)
            .named("view"),
        Shapes.of(
                Fence.class,
                part("who", PROCESS, Fence::who),
                part("suspect", PROCESS, Fence::suspect),
                part("open", sections, Fence::open),
                Fence::new)
            .named("fence"),
        Shapes.of(
                StandsIn.class,
                part("who", PROCESS, StandsIn::who),
                part("sections", sections, StandsIn::sections),
                StandsIn::new)
            .named("stands_in"));
  }

  /** What a reader of traces needs. */
  Vocabulary VOCABULARY =
      Vocabulary.NONE
          .messages(PRIMITIVE, MutexMessage.SHAPE)
          .facts(PRIMITIVE, SHAPE)
          .variables(PRIMITIVE, CRIT, FAILED, FAILURE);

  /** The phases of {@link MutexProtocol.Phase}, for all ids of a robot's program together. */
  Phases PHASES =
      Phases.of(PRIMITIVE, MutexMessage.class, () -> MutexFact::phase, (Object[]) Phase.values());

  private static String phase(String before, TraceEvent event) {
    if (!(event instanceof TraceEvent.Action action)) {
      return before;
    }
    return switch (action.fact()) {
      case DoMutex request -> Phase.TRYING.name();
      case OdMutex access -> Phase.CRITICAL.name();
      case Withdraw end -> Phase.IDLE.name();
      case Release release -> release.left().isEmpty() ? Phase.IDLE.name() : before;
      default -> before;
    };
  }

  /** The instance {@code xid} in the trace: {@code mutex/crossing}. */
  static Instance source(String xid) {
    return Instance.of(PRIMITIVE, xid);
  }
}
