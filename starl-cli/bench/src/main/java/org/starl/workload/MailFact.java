package org.starl.workload;

import static org.starl.shape.Shapes.INT;
import static org.starl.shape.Shapes.LONG;
import static org.starl.shape.Shapes.ROBOT;
import static org.starl.shape.Shapes.part;

import java.util.Optional;
import org.starl.id.RobotId;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.SumShape;
import org.starl.trace.Instance;

/** What a trace tells of the letters of a {@link MessagesClient}. */
sealed interface MailFact {

  /** The instance in the trace, and the kind of the channels. */
  Instance SOURCE = Instance.of("mail");

  /** How a letter is sent. */
  enum Care {
    /** Best effort. */
    NONE,
    /** Reliably, with {@link MessagesClient#BRIEF}. */
    BRIEF,
    /** Reliably, with the default settings. */
    DEFAULT
  }

  /** A channel opens. */
  record Opened(Instance channel) implements MailFact {}

  /** A channel closes. */
  record Closed(Instance channel) implements MailFact {}

  /**
   * A letter is sent.
   *
   * @param to its receiver; all robots if empty
   * @param boot which start of the sender's program
   * @param number among the letters of this start
   */
  record Mailed(Optional<RobotId> to, Instance channel, int boot, int number, Care care)
      implements MailFact {}

  /**
   * A letter is handled.
   *
   * @param itsClock the sender's logical clock, in the letter
   * @param clock the robot's logical clock
   */
  record Handled(RobotId from, Instance channel, int boot, int number, long itsClock, long clock)
      implements MailFact {}

  /** The receipt of a letter says that it was delivered. */
  record Delivered(RobotId to, int boot, int number) implements MailFact {}

  /** The receipt of a letter says that it may not have been delivered. */
  record Failed(RobotId to, int boot, int number) implements MailFact {}

  /** The shapes of all facts. */
  SumShape<MailFact> SHAPE = shape();

  private static SumShape<MailFact> shape() {
    Shape<Instance> channel = Shapes.TEXT.as("channel", Instance::name, Instance::named);
    return Shapes.oneOf(
        MailFact.class,
        Shapes.of(Opened.class, part("channel", channel, Opened::channel), Opened::new)
            .named("open"),
        Shapes.of(Closed.class, part("channel", channel, Closed::channel), Closed::new)
            .named("close"),
        Shapes.of(
                Mailed.class,
                part("to", Shapes.optional(ROBOT), Mailed::to),
                part("channel", channel, Mailed::channel),
                part("boot", INT, Mailed::boot),
                part("number", INT, Mailed::number),
                part("care", Shapes.constant(Care.class), Mailed::care),
                Mailed::new)
            .named("send"),
        Shapes.of(
                Handled.class,
                part("from", ROBOT, Handled::from),
                part("channel", channel, Handled::channel),
                part("boot", INT, Handled::boot),
                part("number", INT, Handled::number),
                part("itsClock", LONG, Handled::itsClock),
                part("clock", LONG, Handled::clock),
                Handled::new)
            .named("handle"),
        Shapes.of(
                Delivered.class,
                part("to", ROBOT, Delivered::to),
                part("boot", INT, Delivered::boot),
                part("number", INT, Delivered::number),
                Delivered::new)
            .named("delivered"),
        Shapes.of(
                Failed.class,
                part("to", ROBOT, Failed::to),
                part("boot", INT, Failed::boot),
                part("number", INT, Failed::number),
                Failed::new)
            .named("failed"));
  }
}
