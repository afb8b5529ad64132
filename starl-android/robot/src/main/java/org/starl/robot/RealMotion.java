package org.starl.robot;

import org.starl.body.MotionParameters;
import org.starl.robot.file.Limits;

/** Motion parameters for real wheels. */
public final class RealMotion {

  private RealMotion() {}

  /**
   * The same motion with the deployment's limits: their greatest speed, and their reaction time and
   * speed error, which enlarge every position's error bound and every region to avoid.
   */
  public static MotionParameters of(MotionParameters motion, Limits limits) {
    double most = limits.speedMmPerS();
    return motion.toBuilder()
        .linSpeedMaxMmPerS(Math.min(motion.linSpeedMaxMmPerS(), most))
        .linSpeedMinMmPerS(Math.min(motion.linSpeedMinMmPerS(), most))
        .arcSpeedMaxMmPerS(Math.min(motion.arcSpeedMaxMmPerS(), most))
        .speedError(Math.max(motion.speedError(), limits.speedError()))
        .reactionMs(Math.max(motion.reactionMs(), limits.reactionMs()))
        .build();
  }
}
