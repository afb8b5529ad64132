package org.starl.primitives.geocast;

import java.util.SortedSet;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.id.RobotSet;

/** The origin's knowledge of one of its geocasts. Strand only. */
public final class GeocastReceipt {

  private final GeocastId id;
  private final RobotSet acknowledgedBy;
  private boolean complete;

  GeocastReceipt(GeocastId id, Participants deployment) {
    this.id = id;
    acknowledgedBy = new RobotSet(deployment);
  }

  public GeocastId id() {
    return id;
  }

  /** Whether the interval is over, or the whole deployment has acknowledged. */
  public boolean isComplete() {
    return complete;
  }

  /** The robots that have certainly delivered by now, sorted; others may have delivered, too. */
  public SortedSet<RobotId> acknowledgedBy() {
    return acknowledgedBy.sorted();
  }

  /** Adds the robots that have certainly delivered by now to {@code robots}. */
  public void addAcknowledgedBy(RobotSet robots) {
    robots.addAll(acknowledgedBy);
  }

  /** Returns whether it is the robot's first acknowledgement. */
  boolean acknowledged(RobotId robot) {
    return acknowledgedBy.add(robot);
  }

  void complete() {
    complete = true;
  }
}
