package org.starl.sim.replay;

import java.util.List;
import org.starl.input.BadInput;
import org.starl.sim.RunController;
import org.starl.sim.StepListener;
import org.starl.trace.TraceEvent.Intervention;

/**
 * Repeats the interventions of a recorded run, each after the same step. For one run.
 */
public final class InterventionReplayer implements StepListener {

  private final List<Intervention> todo;
  private int done;

  /**
   * @param interventions the interventions of a trace, in its order
   */
  public InterventionReplayer(List<Intervention> interventions) {
    todo = List.copyOf(interventions);
  }

  @Override
  public void onStep(RunController controller) {
    while (done < todo.size() && todo.get(done).step() == controller.steps()) {
      Intervention next = todo.get(done);
      done++;
      intervene(next, controller);
    }
  }

  private static void intervene(Intervention what, RunController controller) {
    switch (what.name()) {
      case Intervention.FAULT -> controller.fault(what.detail());
      case Intervention.POINT -> {
        String[] xy = what.detail().split(",", -1);
        if (xy.length != 2 || !xy[0].matches("-?\\d{1,9}") || !xy[1].matches("-?\\d{1,9}")) {
          throw bad(what, "expected x,y in mm");
        }
        controller.point(what.robot(), Integer.parseInt(xy[0]), Integer.parseInt(xy[1]));
      }
      case Intervention.STOP -> controller.stop();
      default -> throw bad(what, "expected fault, point or stop");
    }
  }

  private static BadInput bad(Intervention what, String expected) {
    return new BadInput(
        "the intervention after step %s: %s: %s"
            .formatted(what.step(), BadInput.quote(what.name() + " " + what.detail()), expected));
  }
}
