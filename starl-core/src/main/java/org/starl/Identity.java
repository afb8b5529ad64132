package org.starl;

import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;

/** {@code gvh.id}: this robot's name, and the robots that the deployment knows. */
public final class Identity {

  private final RobotId name;
  private final Participants participants;
  private final int boot;
  private int handedOut;

  Identity(RobotId name, Participants participants, int boot) {
    if (boot <= 0) {
      throw new IllegalArgumentException("boot number " + boot + ": expected above 0");
    }
    this.name = name;
    this.participants = participants;
    this.boot = boot;
  }

  public RobotId name() {
    return name;
  }

  /**
   * All robots that the deployment knows at its start. Robots that take part now are in the
   * registration primitive's view.
   */
  public Participants participants() {
    return participants;
  }

  /** How often this robot's program has started, from 1; counted in stable storage. */
  public int boot() {
    return boot;
  }

  /** A process id that this robot has never used and will never use again. */
  public ProcessId freshProcess() {
    handedOut++;
    return new ProcessId(name, ((long) boot << 32) + handedOut);
  }
}
