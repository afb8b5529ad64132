package org.starl.primitives.motion;

import java.util.List;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.Computation;
import org.starl.GlobalVarHolder;
import org.starl.body.MotionParameters;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Region;
import org.starl.gvh.GvhVariable;
import org.starl.motion.Location;
import org.starl.motion.MotionController;
import org.starl.motion.MotionFact;
import org.starl.motion.MotionFlag;
import org.starl.motion.MotionTask;
import org.starl.trace.Instance;

/**
 * The paper's <i>Motioncontrol</i>, under the names of its section 4.1, over the motion automaton
 * {@code gvh.plat.moat}. All instances on a robot share its body, and the last command counts. The
 * package documentation is the contract. Strand only.
 */
public final class MotionControl implements MotionPrim {

  private final GlobalVarHolder gvh;
  private final MotionController moat;

  public MotionControl(GlobalVarHolder gvh) {
    this.gvh = gvh;
    moat = gvh.plat.moat;
  }

  @Override
  public void gotopoint(ItemPosition target, Region avoid) {
    record(new MotionFact.gotopoint(target, avoid));
    move(target, avoid);
  }

  @Override
  public void do_move(ItemPosition target, Region avoid) {
    record(new MotionFact.do_move(target, avoid));
    move(target, avoid);
  }

  private void move(ItemPosition target, Region avoid) {
    MotionParameters p = moat.parameters();
    moat.doMove(target, avoid, from -> plan(target.at(), avoid, p, from));
  }

  private Supplier<@Nullable List<Point>> plan(
      Point target, Region avoid, MotionParameters p, Location.Known from) {
    Obstacles known = gvh.gps.knownObstacles().all();
    Detour way = new Detour(from.pose().at(), from.errorMm(), target, avoid, known, p);
    if (way.isStraight()) {
      return () -> List.of(target);
    }
    Computation<List<Point>> corners = gvh.plat.compute(way::corners);
    return () -> corners.isDone() ? corners.result() : null;
  }

  @Override
  public GvhVariable<MotionTask> target() {
    return moat.target();
  }

  @Override
  public GvhVariable<MotionFlag> motionflag() {
    return moat.motionflag();
  }

  @Override
  public boolean failed() {
    return moat.failed();
  }

  @Override
  public String failure() {
    return moat.failure();
  }

  @Override
  public void motion_stop() {
    moat.motion_stop();
  }

  @Override
  public Instance source() {
    return MotionFact.SOURCE;
  }

  @Override
  public void close() {
    motion_stop();
  }

  private void record(MotionFact fact) {
    gvh.trace.action(MotionFact.SOURCE, MotionFact.SHAPE, fact);
  }
}
