package org.starl;

import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;

/** {@code gvh.id}: this robot's name, and the robots that the deployment knows. */
public final class Identity {

  // Ids of one start are consecutive from here on: far below the next start's, even after 2^31 ids.
  private static final int EPOCH_BITS = Integer.MAX_VALUE;

  private final RobotId name;
  private final Participants participants;
  private final int boot;
  private final int epoch;
  private int handedOut;

  /**
   * @param epoch of the robot's storage
   */
  Identity(RobotId name, Participants participants, int boot, long epoch) {
    if (boot <= 0) {
      throw new IllegalArgumentException("boot number " + boot + ": expected above 0");
    }
    this.name = name;
    this.participants = participants;
    this.boot = boot;
    this.epoch = (int) epoch & EPOCH_BITS;
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

  /**
   * A process id that this robot has never used and will never use again. Its upper half is {@link
   * #boot}; the lower half begins at the epoch of the robot's storage, so that ids do not return
   * when the storage is lost and boots are counted from 1 again.
   */
  public ProcessId freshProcess() {
    handedOut++;
    return new ProcessId(name, ProcessId.first(name, boot).inc() + epoch + handedOut - 1);
  }
}
