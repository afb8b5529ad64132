package org.starl.sim.view;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.sim.record.BoundingBox;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Look;
import org.starl.sim.record.Part;
import org.starl.sim.record.Scene;
import org.starl.sim.record.Theme;
import org.starl.sim.record.Viewport;

/** The visible part of the floor, its look, and the selected robot. */
final class ViewState {

  private static final int MARGIN_PX = 28;
  private static final double PICK_PX = 6;

  private Look look;
  private Viewport viewport = new Viewport(1, 1, new Point(0, 0), 0.1);
  private final BoundingBox extent = new BoundingBox();
  private boolean isFitted = true;
  private boolean isFollowing;
  private @Nullable RobotId selected;

  ViewState(Look look) {
    this.look = look;
  }

  Look look() {
    return look;
  }

  Viewport viewport() {
    return viewport;
  }

  boolean shows(Part part) {
    return look.shows(part);
  }

  void show(Part part, boolean isOn) {
    look = look.with(part, isOn);
  }

  void show(String part, boolean isOn) {
    look = look.with(part, isOn);
  }

  void paintIn(Theme theme) {
    look = look.in(theme);
  }

  @Nullable RobotId selected() {
    return selected;
  }

  void select(@Nullable RobotId robot) {
    selected = robot;
    look = look.about(robot);
    if (robot == null) {
      isFollowing = false;
    }
  }

  /** Selects the next or previous robot on the floor; the first or last if none is selected. */
  void selectNeighbour(Scene scene, boolean isNext) {
    List<RobotId> robots = new ArrayList<>();
    scene.forEachBody((robot, number, pose, radiusMm) -> robots.add(robot));
    if (robots.isEmpty()) {
      select(null);
      return;
    }
    int at = selected == null ? -1 : robots.indexOf(selected);
    int next = isNext ? at + 1 : (at < 0 ? robots.size() : at) - 1;
    select(robots.get(Math.floorMod(next, robots.size())));
  }

  /** The robot closest to a pixel, if that is on its body or within 6 pixels of it; else null. */
  @Nullable RobotId robotAt(Scene scene, double xPx, double yPx) {
    RobotId[] best = new RobotId[1];
    double[] bestPx = {Double.MAX_VALUE};
    scene.forEachBody((robot, number, pose, radiusMm) -> {
      double dx = viewport.xPx(pose.at()) - xPx;
      double dy = viewport.yPx(pose.at()) - yPx;
      double px = Math.sqrt(dx * dx + dy * dy);
      if (px <= radiusMm * viewport.pxPerMm() + PICK_PX && px < bestPx[0]) {
        bestPx[0] = px;
        best[0] = robot;
      }
    });
    return best[0];
  }

  boolean isFollowing() {
    return isFollowing;
  }

  /** Sets whether the selected robot stays in the centre. */
  void follow(boolean isOn) {
    isFollowing = isOn && selected != null;
    if (isFollowing) {
      isFitted = false;
    }
  }

  /** Shows the whole floor, also when the window or the world grows. */
  void fit() {
    isFitted = true;
    isFollowing = false;
  }

  void pan(double rightPx, double downPx) {
    isFitted = false;
    isFollowing = false;
    viewport = viewport.panned(rightPx, downPx);
  }

  void zoom(double factor, double xPx, double yPx) {
    isFitted = false;
    viewport = viewport.zoomed(factor, xPx, yPx);
  }

  /** Updates the viewport; to be called before each painting. */
  void arrange(Scene scene, Layer layer, int widthPx, int heightPx) {
    int width = Math.max(1, widthPx);
    int height = Math.max(1, heightPx);
    if (isFitted) {
      extent.include(BoundingBox.of(scene, layer));
      viewport = Viewport.fit(extent, width, height, MARGIN_PX);
    } else if (width != viewport.widthPx() || height != viewport.heightPx()) {
      viewport = viewport.resized(width, height);
    }
    RobotId followed = isFollowing ? selected : null;
    if (followed != null) {
      viewport = scene.pose(followed).map(Pose::at).map(viewport::around).orElse(viewport);
    }
  }
}
