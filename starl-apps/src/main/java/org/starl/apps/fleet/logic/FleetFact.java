package org.starl.apps.fleet.logic;

import java.util.List;
import org.starl.primitives.monitor.PrimitiveVocabulary;
import org.starl.shape.Shapes;
import org.starl.trace.Instance;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;

/** What a trace tells of a fleet. */
public final class FleetFact {

  /** What the robot does. */
  public enum Work {
    STARTS,
    PARKS,
    FETCHES,
    CARRIES,
    RETURNS,
    CHARGES,
    ENDS
  }

  /** What the robot does. */
  public static final Var<Work> WORK = Var.of("work", Work.class);

  /** The vertices ahead, the one to which it drives now first. */
  public static final Var<List<Integer>> WAY = Var.of("way", Shapes.list(Shapes.INT, 10_000));

  /** The two ends of the lane on which it drives; empty while it is on none. */
  public static final Var<List<Integer>> LANE = Var.of("lane", Shapes.list(Shapes.INT, 2));

  /** The number of the delivery whose load is aboard; 0 for none. */
  public static final Var<Long> ABOARD = Var.of("aboard", Shapes.LONG);

  /** The number of the delivery whose load it has put down last; 0 before the first. */
  public static final Var<Long> DELIVERED = Var.of("delivered", Shapes.LONG);

  /** Charge of the battery, in percent. */
  public static final Var<Integer> CHARGE = Var.of("charge", Shapes.INT);

  /** What a reader of traces needs. */
  public static final Vocabulary VOCABULARY =
      PrimitiveVocabulary.ALL.variables(
          Instance.APP.primitive(), WORK, WAY, LANE, ABOARD, DELIVERED, CHARGE);

  private FleetFact() {}
}
