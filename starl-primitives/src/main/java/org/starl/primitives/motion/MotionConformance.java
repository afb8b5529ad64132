package org.starl.primitives.motion;

import org.jspecify.annotations.Nullable;
import org.starl.body.MotionParameters;
import org.starl.id.RobotId;
import org.starl.motion.MotionFact;
import org.starl.motion.MotionFlag;
import org.starl.primitives.motion.MotionControlAutomaton.States;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Replay;
import org.starl.spec.automaton.Sets;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Variable;

/**
 * Every run's motions are a run of the theory {@code MotionControl_decls}. The map from events to
 * actions, where {@code i} is the event's robot, and {@code n} the number of the command:
 *
 * <pre>
 * event                             action
 * doMove t A                        do_move(i, n, n)
 * doMove t A, avoids owes nothing   do_move(i, n, 0): nothing to avoid
 * turnTo t                          do_move(i, n, n): A is empty, and every place is near t
 * a body enters A of its command    move(i, in n)
 * motionflag DONE                   move(i, near n) if the body is near t, then arrived(i)
 * motionflag FAIL                   failed(i)
 * motion_stop                       motion_stop(i)
 * motionflag IDLE                   none, or motion_stop(i) if the program has started again
 * fault crash                       motion_stop(i): the command is lost with the program
 * motionflag MOVING, planned        none
 * all other events, other moves     none
 * </pre>
 *
 * After each change of {@code motionflag} the automaton must have the same value. Bodies are the
 * true ones; the tolerances of {@link MotionSpec} decide whether a body is in A, or near t. If the
 * body was in A at the command, or too close for the wheels to react, the theory's assumption does
 * not hold, and that specification requires nothing for A. Then the command counts as one without
 * A. The same holds for a body that is put down in A: this is no action. If a body enters A between
 * two events, its step comes at the later one. Memory holds one command for each robot.
 */
public final class MotionConformance extends Conformance<Replay<States, MotionControlAction>> {

  private final MotionBodies bodies;

  // The single instance, for the motions of all robots.
  private final Replay<States, MotionControlAction> replay;

  /**
   * @param parameters how the robots move, as for {@link MotionSpec}
   */
  public MotionConformance(MotionParameters parameters) {
    this(parameters, AutomatonListener.none());
  }

  /**
   * @param steps receives every step
   */
  MotionConformance(
      MotionParameters parameters, AutomatonListener<States, MotionControlAction> steps) {
    super(
        MotionControlAutomaton.MOTION_CONTROL_DECLS,
        "all motions",
        source -> new Replay<>(new MotionControlAutomaton(Place::isNear), source, steps),
        MotionFact.SOURCE.kind());
    bodies = new MotionBodies(parameters);
    replay = instance(MotionFact.SOURCE);
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    if (!replay.hasDeviated()) {
      bodies.observe(event, (motion, moved) -> followed(motion, moved, report));
      super.observe(event, report);
    }
  }

  @Override
  protected void happened(TraceEvent event, Report report) {
    if (event instanceof Fault fault && fault.name().equals(Fault.CRASH)) {
      replay.step(fault, new MotionControlAction.motion_stop(fault.robot()), report);
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    bodies.finish(endNs, (motion, moved) -> followed(motion, moved, report));
  }

  private void followed(MotionRecord motion, @Nullable Moved moved, Report report) {
    if (moved != null) {
      Place inside = Place.of(Sets.singleton(motion.number), Sets.emptyset());
      replay.step(moved, new MotionControlAction.move(motion.robot, inside), report);
    }
  }

  @Override
  protected void acted(Action action, Report report) {
    switch (action.fact()) {
      case MotionFact.doMove f -> commanded(action, report);
      case MotionFact.turnTo f -> commanded(action, report);
      case MotionFact.motion_stop f ->
          replay.step(action, new MotionControlAction.motion_stop(action.robot()), report);
      default -> {}
    }
  }

  private void commanded(Action action, Report report) {
    RobotId i = action.robot();
    MotionRecord motion = bodies.of(i);
    if (motion != null) {
      boolean isFree = bodies.isOnFloor(i) && !motion.owesAvoids;
      Area avoid = isFree ? Area.NONE : new Area(motion.number);
      Place target = Place.target(motion.number);
      replay.step(action, new MotionControlAction.do_move(i, target, avoid), report);
    }
  }

  @Override
  protected void changed(Variable variable, Report report) {
    MotionFlag flag = variable.of(MotionFact.FLAG);
    if (flag == null) {
      return;
    }
    RobotId i = variable.robot();
    switch (flag) {
      case DONE -> {
        MotionRecord motion = bodies.of(i);
        if (motion != null && bodies.isNear(motion, variable.timeNs())) {
          Place near = Place.of(Sets.emptyset(), Sets.singleton(motion.number));
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
        // No action of the theory.
      }
    }
    replay.result(variable, "motionflag", i, flag, replay.state().motionflag().at(i), report);
  }
}
