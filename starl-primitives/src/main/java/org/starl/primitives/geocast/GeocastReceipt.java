package org.starl.primitives.geocast;

import java.util.Collections;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.id.RobotId;

/** The origin's knowledge of one of its geocasts. Strand only. */
public final class GeocastReceipt {

  private final GeocastId id;
  private final SortedSet<RobotId> acknowledgedBy = new TreeSet<>();
  private boolean complete;

  GeocastReceipt(GeocastId id) {
    this.id = id;
  }

  public GeocastId id() {
    return id;
  }

  /** Whether the interval is over, or the whole deployment has acknowledged. */
  public boolean isComplete() {
    return complete;
  }

  /** The robots that have certainly delivered, sorted; others may have delivered, too. */
  public SortedSet<RobotId> acknowledgedBy() {
    return Collections.unmodifiableSortedSet(acknowledgedBy);
  }

  void acknowledged(RobotId robot) {
    acknowledgedBy.add(robot);
  }

  void complete() {
    complete = true;
  }
}
