package org.starl.workload;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.starl.apps.Demo;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.input.Form;
import org.starl.input.Quantity;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.fault.Envelope;
import org.starl.sim.record.Layer;

/**
 * A primitive's workload as the command line knows it.
 *
 * @param envelope the faults that the primitive tolerates
 * @param preparation adds robots and monitors
 */
record PrimitiveWorkload(
    String name,
    String summary,
    Envelope envelope,
    int maxRobots,
    List<Parameter> parameters,
    Consumer<Setup> preparation)
    implements Demo {

  /** The parameters that all workloads have, and more. */
  static List<Parameter> parameters(int rounds, String busy, Parameter... more) {
    List<Parameter> parameters = new ArrayList<>();
    parameters.add(
        new Parameter(
            Setup.ROUNDS,
            Integer.toString(rounds),
            "how often each robot asks, from 1",
            Form.whole(1, Setup.MAX_ROUNDS)));
    parameters.add(
        new Parameter(
            Setup.BUSY,
            busy,
            "time over which rounds and chaos are spread; the last three rounds begin after it",
            Form.amount(Quantity.DURATION)));
    parameters.addAll(List.of(more));
    return List.copyOf(parameters);
  }

  @Override
  public Kind kind() {
    return Kind.PRIMITIVE;
  }

  @Override
  public SimSettings.Builder defaultSettings(Request request) {
    return SimSettings.builder()
        .set(Setting.CHAOS_FOR, Duration.ofMillis(Setup.course(request).busyMs()));
  }

  @Override
  public Plan plan(Request request, SimSettings settings) {
    RoundsStory story = new RoundsStory();
    Setup setup = new Setup(request, settings, maxRobots);
    setup.simulation().observer(story);
    preparation.accept(setup);
    return new Plan(setup.simulation(), story, Layer.NONE, setup.simulation().obstacles());
  }
}
