package org.starl.robot;

import org.starl.body.MotionParameters;
import org.starl.robot.file.Limits;

/** How an app's robots move on real wheels. */
public final class RealMotion {

  private RealMotion() {}

  /**
   * The same motion, no faster than the deployment's limits, and as late and as wrong as they say that
   * the wheels are: every position's error bound and every region to avoid have that in them.
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
