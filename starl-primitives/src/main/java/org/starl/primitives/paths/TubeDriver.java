package org.starl.primitives.paths;

import static org.starl.time.Time.NS_PER_MS;

import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.body.MotionParameters;
import org.starl.geometry.ItemPosition;
import org.starl.motion.MotionController;
import org.starl.motion.MotionFlag;
import org.starl.platform.Timer;

/**
 * Drives a robot along a tube, part by part; the border of the current part is the region to avoid.
 * A part is passed when the whole body is certainly inside the next one. Strand only.
 */
final class TubeDriver {

  private static final long LOOK_NS = 50 * NS_PER_MS;

  private final GlobalVarHolder gvh;
  private final Listener listener;
  private final Timer timer;
  private @Nullable Tube tube;
  private int part;
  private long doneNs;
  private boolean driving;

  /** Receives the progress of a drive. */
  interface Listener {

    /** The body has passed {@code parts} parts, and goes on inside {@code rest}. */
    void passed(int parts, Tube rest);

    /** The robot stands inside the disc at the tube's end. */
    void arrived(Tube end);

    /** The robot has stopped inside the tube, before its end. */
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
      // The robot stands, so its position error shrinks with the next fix.
      if (nowNs - doneNs > gvh.plat.moat.parameters().failFixAgeMs() * NS_PER_MS) {
        fail("the position is too uncertain");
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
      throw new IllegalStateException("no tube to drive along");
    }
    return tube;
  }

  private void lookAgain() {
    timer.set(gvh.plat.clock.nowNs() + LOOK_NS);
  }
}
