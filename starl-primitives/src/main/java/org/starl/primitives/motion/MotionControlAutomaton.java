package org.starl.primitives.motion;

import java.util.SortedSet;
import org.starl.id.RobotId;
import org.starl.motion.MotionFlag;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Sets;

/**
 * The theory {@code MotionControl_decls} as an executable automaton: bodies that move under
 * commands. {@code PIDS} are robots. A command's number represents the command, its target, and its
 * area to avoid. A place, of {@code Places}, is represented by the areas that a body there is in,
 * and the targets it is near: {@code avoid(i)(p)} is {@code p.avoided().contains(avoid(i))}, {@code
 * near(p, t)} is {@code p.near().contains(t)}. {@link MotionConformance} replays runs on it.
 */
public final class MotionControlAutomaton
    implements Automaton<MotionControlAutomaton.States, MotionControlAction> {

  /** The theory's name. */
  public static final String MOTION_CONTROL_DECLS = "MotionControl_decls";

  /** The empty set of places: no command has this number. */
  public static final long EMPTYSET = 0;

  /**
   * A place.
   *
   * @param avoided the commands whose area to avoid contains it
   * @param near the commands whose target it is near
   */
  public record Place(SortedSet<Long> avoided, SortedSet<Long> near) {

    static final Place ELSEWHERE = new Place(Sets.emptyset(), Sets.emptyset());

    @Override
    public String toString() {
      return "in " + avoided + ", near " + near;
    }
  }

  /**
   * The theory's states.
   *
   * @param pos the place of a body
   * @param target the target of the last command
   * @param avoid the area to avoid of the last command
   * @param motionflag the status of the last command
   * @param at the place of a body when {@code motionflag} became DONE
   */
  public record States(
      Fun<RobotId, Place> pos,
      Fun<RobotId, Long> target,
      Fun<RobotId, Long> avoid,
      Fun<RobotId, MotionFlag> motionflag,
      Fun<RobotId, Place> at) {

    private States withFlag(RobotId i, MotionFlag flag) {
      return new States(pos, target, avoid, motionflag.with(i, flag), at);
    }
  }

  @Override
  public String theory() {
    return MOTION_CONTROL_DECLS;
  }

  @Override
  public States start() {
    return new States(
        Fun.always(Place.ELSEWHERE),
        Fun.always(EMPTYSET),
        Fun.always(EMPTYSET),
        Fun.always(MotionFlag.IDLE),
        Fun.always(Place.ELSEWHERE));
  }

  @Override
  public Enabled enabled(MotionControlAction action, States s) {
    return switch (action) {
      case MotionControlAction.do_move a -> {
        Place here = s.pos.at(a.i());
        yield Enabled.when(
            "NOT A(pos(i))", !here.avoided().contains(a.A()), () -> "pos(" + a.i() + ") = " + here);
      }
      case MotionControlAction.move a -> {
        long avoid = s.avoid.at(a.i());
        MotionFlag flag = s.motionflag.at(a.i());
        yield Enabled.when(
            "NOT motionflag(i) = IDLE IMPLIES NOT avoid(i)(p)",
            flag == MotionFlag.IDLE || !a.p().avoided().contains(avoid),
            () -> "motionflag(" + a.i() + ") = " + flag + ", avoid(" + a.i() + ") = " + avoid);
      }
      case MotionControlAction.arrived a -> {
        long target = s.target.at(a.i());
        Place here = s.pos.at(a.i());
        yield enabledWhileMoving(a.i(), s)
            .and(
                "near(pos(i), target(i))",
                here.near().contains(target),
                () -> "pos(" + a.i() + ") = " + here + ", target(" + a.i() + ") = " + target);
      }
      case MotionControlAction.failed a -> enabledWhileMoving(a.i(), s);
      case MotionControlAction.motion_stop a -> Enabled.TRUE;
    };
  }

  private static Enabled enabledWhileMoving(RobotId i, States s) {
    MotionFlag flag = s.motionflag.at(i);
    return Enabled.when(
        "motionflag(i) = MOVING",
        flag == MotionFlag.MOVING,
        () -> "motionflag(" + i + ") = " + flag);
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
      case MotionControlAction.failed a -> s.withFlag(a.i(), MotionFlag.FAIL);
      case MotionControlAction.motion_stop a -> s.withFlag(a.i(), MotionFlag.IDLE);
    };
  }
}
