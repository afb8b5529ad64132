package org.starl.primitives.paths;

import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.body.MotionParameters;
import org.starl.geometry.ItemPosition;
import org.starl.motion.MotionController;
import org.starl.motion.MotionFlag;
import org.starl.platform.Timer;

/**
 * Drives a robot along a tube, part by part, each with the part's border as the region to avoid. A
 * part is passed when the whole body is inside the next one for certain. Strand only.
 */
final class TubeDriver {

  private static final long NS_PER_MS = 1_000_000;
  private static final long LOOK_NS = 50 * NS_PER_MS;

  private final GlobalVarHolder gvh;
  private final Listener listener;
  private final Timer timer;
  private @Nullable Tube tube;
  private int part;
  private long doneNs;
  private boolean driving;

  /** Takes what becomes of a drive. */
  interface Listener {

    /** The body is inside {@code rest}, without the first {@code parts} parts, and goes on there. */
    void passed(int parts, Tube rest);

    /** The body stands inside the disc at the tube's end. */
    void arrived(Tube end);

    /** The wheels are stopped, somewhere in the tube. */
    void stopped(String why);
  }

  TubeDriver(GlobalVarHolder gvh, Listener listener) {
    this.gvh = gvh;
    this.listener = listener;
    this.timer = gvh.plat.timers.timer(this::look);
  }

  /** Whether the whole body is inside {@code part}, position error included. */
  static boolean isInside(GlobalVarHolder gvh, Capsule part) {
    double bodyMm = gvh.plat.moat.parameters().robotRadiusMm();
    return gvh.gps.hasFix() && part.containsDisc(gvh.gps.pose().at(), bodyMm + gvh.gps.errorMm());
  }

  void drive(Tube newTube) {
    tube = newTube;
    part = 0;
    driving = true;
    driveAlongPart();
  }

  void stop() {
    if (driving) {
      driving = false;
      timer.cancel();
      gvh.plat.moat.motion_stop();
    }
  }

  private void driveAlongPart() {
    Capsule now = tube().part(part);
    MotionController moat = gvh.plat.moat;
    MotionParameters usual = moat.parameters();
    moat.setParameters(Tracking.straight(usual));
    ItemPosition end =
        new ItemPosition("tube" + part, now.axis().to().xMm(), now.axis().to().yMm());
    moat.doMove(end, Tracking.wall(now));
    moat.setParameters(usual);
    doneNs = Long.MAX_VALUE;
    lookAgain();
  }

  private void look() {
    MotionFlag flag = gvh.plat.moat.motionflag().get();
    switch (flag) {
      case MOVING -> lookAgain();
      case DONE -> endOfPart();
      case FAIL, IDLE -> fail(flag == MotionFlag.FAIL ? gvh.plat.moat.failure() : "stopped");
    }
  }

  private void endOfPart() {
    long nowNs = gvh.plat.clock.nowNs();
    doneNs = Math.min(doneNs, nowNs);
    Tube rest = tube().from(part + 1);
    if (!isInside(gvh, rest.part(0))) {
      // It stands, so its error shrinks with the next fix.
      if (nowNs - doneNs > gvh.plat.moat.parameters().failFixAgeMs() * NS_PER_MS) {
        fail("its place is not known well enough");
      } else {
        lookAgain();
      }
    } else if (part + 1 >= tube().parts()) {
      driving = false;
      listener.arrived(rest);
    } else {
      part++;
      driveAlongPart();
      listener.passed(part, rest);
    }
  }

  private void fail(String why) {
    stop();
    listener.stopped(why);
  }

  private Tube tube() {
    if (tube == null) {
      throw new IllegalStateException("drives no tube");
    }
    return tube;
  }

  private void lookAgain() {
    timer.set(gvh.plat.clock.nowNs() + LOOK_NS);
  }
}
