package org.starl.primitives.motion;

import org.jspecify.annotations.Nullable;
import org.starl.body.MotionParameters;
import org.starl.id.RobotId;
import org.starl.motion.MotionFlag;
import org.starl.primitives.motion.MotionControlAutomaton.Place;
import org.starl.primitives.motion.MotionControlAutomaton.States;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Replay;
import org.starl.spec.automaton.Sets;
import org.starl.spec.automaton.Steps;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Variable;

/**
 * Every run's motions are a run of the theory {@code MotionControl_decls}: the lemma is its name.
 * What happens is taken for an action of the theory so, {@code i} being the event's robot, and {@code
 * n} the number of the command:
 *
 * <pre>
 * event                          action
 * doMove t A                     do_move(i, n, n)
 * doMove t A, nothing being owed do_move(i, n, 0): there is nothing to avoid
 * turnTo t                       do_move(i, n, n): nothing is in A, every place is near t
 * a body enters A of its command move(i, in n)
 * motionflag DONE                move(i, near n) if its body is near t, then arrived(i)
 * motionflag FAIL                failed(i)
 * motion_stop                    motion_stop(i)
 * motionflag IDLE                stutter, or motion_stop(i) if the program has begun anew
 * fault crash                    motion_stop(i): the command is forgotten with its program
 * motionflag MOVING              stutter
 * all other events               stutter, so is what else a body does
 * </pre>
 *
 * After each value of {@code motionflag} the automaton has the same. Bodies are the true ones; what is
 * in A and what is near t is decided as {@link MotionSpec} does, with its tolerances. Where it owes
 * nothing of A, since the body was in it at the command, or so near that the wheels could not take
 * notice, the theory's assumption does not hold, and the command counts as one without A. So it is
 * where a body is put down in A: that it is there is a stutter. A body enters A between two events,
 * and its step comes at the later one. What is kept is one command for each robot.
 */
public final class MotionConformance extends Conformance {

  private final MotionBodies bodies;
  private final Replay<States, MotionControlAction> replay;

  /**
   * @param parameters how the robots move, as {@link MotionSpec} is given them
   */
  public MotionConformance(MotionParameters parameters) {
    this(parameters, Steps.ignored());
  }

  /**
   * The same.
   *
   * @param steps takes every step
   */
  MotionConformance(MotionParameters parameters, Steps<States, MotionControlAction> steps) {
    super(MotionControlAutomaton.MOTION_CONTROL_DECLS, "all motions");
    bodies = new MotionBodies(parameters);
    replay = new Replay<>(new MotionControlAutomaton(), MotionTrace.SOURCE, steps);
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    if (replay.isOver()) {
      return;
    }
    bodies.observe(event, (motion, moved) -> followed(motion, moved, report));
    switch (event) {
      case Action action when action.source().equals(MotionTrace.SOURCE) -> acted(action, report);
      case Variable variable when MotionTrace.isFlag(variable) -> flagged(variable, report);
      case Fault fault when fault.name().equals(Fault.CRASH) ->
          replay.step(fault, new MotionControlAction.motion_stop(fault.robot()), report);
      default -> {
        // A stutter.
      }
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    bodies.finish(endNs, (motion, moved) -> followed(motion, moved, report));
  }

  private void followed(MotionRecord motion, @Nullable Moved moved, Report report) {
    if (moved != null) {
      Place inside = new Place(Sets.singleton(motion.number), Place.ELSEWHERE.near());
      replay.step(moved, new MotionControlAction.move(motion.robot, inside), report);
    }
  }

  private void acted(Action action, Report report) {
    RobotId i = action.robot();
    MotionRecord motion = bodies.of(i);
    switch (action.name()) {
      case MotionTrace.MOAT_MOVE, MotionTrace.TURN_TO -> {
        if (motion != null) {
          boolean isFree = bodies.isOnFloor(i) && !motion.owesAvoids;
          long avoid = isFree ? MotionControlAutomaton.EMPTYSET : motion.number;
          replay.step(action, new MotionControlAction.do_move(i, motion.number, avoid), report);
        }
      }
      case MotionTrace.MOTION_STOP ->
          replay.step(action, new MotionControlAction.motion_stop(i), report);
      default -> {
        // A stutter.
      }
    }
  }

  private void flagged(Variable variable, Report report) {
    RobotId i = variable.robot();
    MotionFlag flag = MotionFlag.valueOf(variable.value());
    switch (flag) {
      case DONE -> {
        MotionRecord motion = bodies.of(i);
        if (motion != null && bodies.isNear(motion, variable.timeNs())) {
          Place near = new Place(Place.ELSEWHERE.avoided(), Sets.singleton(motion.number));
          replay.step(variable, new MotionControlAction.move(i, near), report);
        }
        replay.step(variable, new MotionControlAction.arrived(i), report);
      }
      case FAIL -> replay.step(variable, new MotionControlAction.failed(i), report);
      case IDLE -> {
        if (replay.state().motionflag().at(i) != MotionFlag.IDLE) {
          replay.step(variable, new MotionControlAction.motion_stop(i), report);
        }
      }
      case MOVING -> {
        // A stutter.
      }
    }
    replay.result(variable, "motionflag", i, flag, replay.state().motionflag().at(i), report);
  }
}
