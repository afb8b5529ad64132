package org.starl.primitives.ledger;

import static org.starl.shape.Shapes.LONG;
import static org.starl.shape.Shapes.PROCESS;
import static org.starl.shape.Shapes.part;

import java.util.List;
import org.starl.id.ProcessId;
import org.starl.primitives.agreement.Value;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.SumShape;

/**
 * One change in the log. It takes effect if the entries before it allow it, else it has none. An entry
 * takes effect at most once, so it may be in the log twice.
 */
public sealed interface LedgerEntry {

  /** A program of a robot takes part from now on: claims of its earlier ones that are not begun end. */
  record Start(ProcessId who) implements LedgerEntry {}

  /** A new task: the next one of its source. */
  record Add(TaskId task, Value what) implements LedgerEntry {}

  /** A change of a task that is in the ledger, under a claim of it. */
  sealed interface OfClaim extends LedgerEntry {

    TaskId task();

    /** Its number, from 1; 0 for none: then it has no effect. */
    long claim();
  }

  /** The robot's program takes the open task, as its claim of this number. */
  record Claim(TaskId task, long claim, ProcessId who) implements OfClaim {}

  /** The point of no return, while the claim stands. */
  record Begin(TaskId task, long claim, ProcessId who) implements OfClaim {}

  /** The task is done, by the robot that has begun it. */
  record Finish(TaskId task, long claim, ProcessId who) implements OfClaim {}

  /** Ends a claim that is not begun: it is given back, or its lease has run out. */
  record Free(TaskId task, long claim) implements OfClaim {}

  /** Ends a claim that is begun: the application says that the task can be done again. */
  record Reopen(TaskId task, long claim) implements OfClaim {}

  /** Its shape. */
  SumShape<LedgerEntry> SHAPE =
      Shapes.oneOf(
          LedgerEntry.class,
          Shapes.of(Start.class, part("who", PROCESS, Start::who), Start::new),
          Shapes.of(
              Add.class,
              part("task", TaskId.SHAPE, Add::task),
              part("what", Value.SHAPE, Add::what),
              Add::new),
          Shapes.of(
              Claim.class,
              part("task", TaskId.SHAPE, Claim::task),
              part("claim", LONG, Claim::claim),
              part("who", PROCESS, Claim::who),
              Claim::new),
          Shapes.of(
              Begin.class,
              part("task", TaskId.SHAPE, Begin::task),
              part("claim", LONG, Begin::claim),
              part("who", PROCESS, Begin::who),
              Begin::new),
          Shapes.of(
              Finish.class,
              part("task", TaskId.SHAPE, Finish::task),
              part("claim", LONG, Finish::claim),
              part("who", PROCESS, Finish::who),
              Finish::new),
          Shapes.of(
              Free.class,
              part("task", TaskId.SHAPE, Free::task),
              part("claim", LONG, Free::claim),
              Free::new),
          Shapes.of(
              Reopen.class,
              part("task", TaskId.SHAPE, Reopen::task),
              part("claim", LONG, Reopen::claim),
              Reopen::new));

  /** The entries of one decree. */
  Shape<List<LedgerEntry>> LIST = Shapes.list(SHAPE, 0xFF);
}
