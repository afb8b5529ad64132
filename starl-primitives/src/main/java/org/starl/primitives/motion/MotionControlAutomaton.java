// Generated from MotionControl_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.motion;

import java.util.function.BiPredicate;
import org.starl.id.RobotId;
import org.starl.motion.MotionFlag;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Fun;

/**
 * The automaton MotionControl_decls, executable.
 *
 * <p>Motion control (paper, section 4.1): do_move(t, A) moves a body to t, round A.
 *
 * <p>Under a command the body is never in the command's A, whether it moves or has told how it
 * went; motionflag becomes DONE only near the target. A body without a command (IDLE) may be
 * anywhere. gotopoint(t) is do_move with nothing to avoid.
 *
 * <p>`near' is what counts as arrived. Assumed: whoever calls is not in A, and whoever pushes a
 * body keeps it out of A (`move' is the body's movement, whatever its cause). Java:
 * org.starl.primitives.motion.Motioncontrol over org.starl.motion; `pos' is the true position; this
 * automaton: MotionControlAutomaton; monitors: MotionSpec, MotionConformance.
 */
public final class MotionControlAutomaton
    implements Automaton<MotionControlAutomaton.States, MotionControlAction> {

  /** The theory's name. */
  public static final String MOTION_CONTROL_DECLS = "MotionControl_decls";

  private final BiPredicate<Place, Place> near;

  /** Of the theory's parameters. */
  public MotionControlAutomaton(BiPredicate<Place, Place> near) {
    this.near = near;
  }

  /**
   * The states.
   *
   * @param at where it was when motionflag became DONE
   */
  public record States(
      Fun<RobotId, Place> pos,
      Fun<RobotId, Place> target,
      Fun<RobotId, Area> avoid,
      Fun<RobotId, MotionFlag> motionflag,
      Fun<RobotId, Place> at) {}

  @Override
  public String theory() {
    return MOTION_CONTROL_DECLS;
  }

  @Override
  public States start() {
    return new States(
        Fun.always(Place.ELSEWHERE),
        Fun.always(Place.ELSEWHERE),
        Fun.always(Area.NONE),
        Fun.always(MotionFlag.IDLE),
        Fun.always(Place.ELSEWHERE));
  }

  @Override
  public Enabled enabled(MotionControlAction action, States s) {
    return switch (action) {
      case MotionControlAction.do_move a ->
          Enabled.when(
              "not pos(i) in A",
              !a.A().contains(s.pos.at(a.i())),
              () -> "pos(" + a.i() + ") = " + s.pos.at(a.i()));
      case MotionControlAction.move a ->
          Enabled.when(
              "not motionflag(i) = IDLE => not p in avoid(i)",
              s.motionflag.at(a.i()) == MotionFlag.IDLE || !s.avoid.at(a.i()).contains(a.p()),
              () ->
                  String.format(
                      "motionflag(%s) = %s, avoid(%s) = %s",
                      a.i(), s.motionflag.at(a.i()), a.i(), s.avoid.at(a.i())));
      case MotionControlAction.arrived a ->
          Enabled.when(
                  "motionflag(i) = MOVING",
                  s.motionflag.at(a.i()) == MotionFlag.MOVING,
                  () -> "motionflag(" + a.i() + ") = " + s.motionflag.at(a.i()))
              .and(
                  "near(pos(i), target(i))",
                  near.test(s.pos.at(a.i()), s.target.at(a.i())),
                  () ->
                      String.format(
                          "pos(%s) = %s, target(%s) = %s",
                          a.i(), s.pos.at(a.i()), a.i(), s.target.at(a.i())));
      case MotionControlAction.failed a ->
          Enabled.when(
              "motionflag(i) = MOVING",
              s.motionflag.at(a.i()) == MotionFlag.MOVING,
              () -> "motionflag(" + a.i() + ") = " + s.motionflag.at(a.i()));
      case MotionControlAction.motion_stop a -> Enabled.TRUE;
    };
  }

  @Override
  public States trans(MotionControlAction action, States s) {
    return switch (action) {
      case MotionControlAction.do_move a ->
          new States(
              s.pos,
              s.target.with(a.i(), a.t()),
              s.avoid.with(a.i(), a.A()),
              s.motionflag.with(a.i(), MotionFlag.MOVING),
              s.at);
      case MotionControlAction.move a ->
          new States(s.pos.with(a.i(), a.p()), s.target, s.avoid, s.motionflag, s.at);
      case MotionControlAction.arrived a ->
          new States(
              s.pos,
              s.target,
              s.avoid,
              s.motionflag.with(a.i(), MotionFlag.DONE),
              s.at.with(a.i(), s.pos.at(a.i())));
      case MotionControlAction.failed a ->
          new States(s.pos, s.target, s.avoid, s.motionflag.with(a.i(), MotionFlag.FAIL), s.at);
      case MotionControlAction.motion_stop a ->
          new States(s.pos, s.target, s.avoid, s.motionflag.with(a.i(), MotionFlag.IDLE), s.at);
    };
  }
}
