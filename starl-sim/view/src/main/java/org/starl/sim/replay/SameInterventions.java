package org.starl.sim.replay;

import java.util.List;
import org.starl.input.BadInput;
import org.starl.sim.RunController;
import org.starl.sim.StepListener;
import org.starl.trace.TraceEvent.Intervention;

/**
 * Does to a run what a person did to an equal one, each thing after the same step. Good for one run.
 */
public final class SameInterventions implements StepListener {

  private final List<Intervention> todo;
  private int done;

  /**
   * @param interventions of a trace, in its order
   */
  public SameInterventions(List<Intervention> interventions) {
    todo = List.copyOf(interventions);
  }

  @Override
  public void onStep(RunController hands) {
    while (done < todo.size() && todo.get(done).step() == hands.steps()) {
      Intervention next = todo.get(done);
      done++;
      intervene(next, hands);
    }
  }

  private static void intervene(Intervention what, RunController hands) {
    switch (what.name()) {
      case Intervention.FAULT -> hands.fault(what.detail());
      case Intervention.POINT -> {
        String[] xy = what.detail().split(",", -1);
        if (xy.length != 2 || !xy[0].matches("-?\\d{1,9}") || !xy[1].matches("-?\\d{1,9}")) {
          throw bad(what, "expected x,y in mm");
        }
        hands.point(what.robot(), Integer.parseInt(xy[0]), Integer.parseInt(xy[1]));
      }
      case Intervention.STOP -> hands.stop();
      default -> throw bad(what, "expected an intervention fault, point or stop");
    }
  }

  private static BadInput bad(Intervention what, String expected) {
    return new BadInput(
        "the intervention after step "
            + what.step()
            + ": "
            + BadInput.quote(what.name() + " " + what.detail())
            + ": "
            + expected);
  }
}
