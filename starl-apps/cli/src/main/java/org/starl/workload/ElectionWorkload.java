package org.starl.workload;

import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.apps.Parameter;
import org.starl.apps.Request;
import org.starl.input.BadInput;
import org.starl.input.Form;
import org.starl.primitives.election.Election;
import org.starl.primitives.election.ElectionSettings;
import org.starl.primitives.election.ElectionSpec;
import org.starl.primitives.election.ElectionStrategy;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/** {@code starl campaign election}: in each round all robots take part in one more election. */
final class ElectionWorkload extends PrimitiveDemo {

  private static final long DEADLINE_MS = 10_000;
  private static final long THINK_MS = 1_000;
  private static final long NS_PER_MS = 1_000_000;

  private static final Parameter STRATEGY =
      new Parameter(
          "strategy",
          "random",
          "how robots elect: random (ballots) or bully",
          Form.choice(List.of("random", "bully")));

  ElectionWorkload() {
    super("election", "robots elect one leader after another, and follow all of them");
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(rounds(5), busy("20s"), STRATEGY);
  }

  @Override
  void prepare(Simulation.Builder simulation, Request request, SimSettings settings) {
    Course course = course(request);
    ElectionSettings how =
        ElectionSettings.DEFAULT
            .withStrategy(strategy(request.parameter(STRATEGY.key())))
            .withDeadlineMs(DEADLINE_MS);
    place(simulation, settings, count(request, 1, 64), gvh -> new Voter(gvh, course, how));
    // By a clock that is slow by a tenth and was put back by a second, the deadline is later.
    long toldNs = (DEADLINE_MS + DEADLINE_MS / 5 + 1_000) * NS_PER_MS;
    simulation.monitor(() -> new ElectionSpec(Bounds.withinNs(settings), toldNs));
  }

  private static ElectionStrategy strategy(String name) {
    return switch (name) {
      case "random" -> ElectionStrategy.RANDOM_BALLOT;
      case "bully" -> ElectionStrategy.BULLY;
      default ->
          throw new BadInput("strategy=" + BadInput.quote(name) + ": expected random or bully");
    };
  }

  private static final class Voter extends Client {
    // All from the start: each votes, whether this robot takes part already or not.
    private final List<Election> elections = new ArrayList<>();

    Voter(GlobalVarHolder gvh, Course course, ElectionSettings settings) {
      super(gvh, course, THINK_MS);
      for (int i = 0; i < course.rounds(); i++) {
        elections.add(new Election(gvh, "round" + i, gvh.id.participants(), settings));
      }
    }

    @Override
    protected boolean obtain(int round) {
      Election election = elections.get(round);
      election.do_election();
      await(() -> election.Leader().get().isElected() || election.failed().get());
      return election.Leader().get().isElected();
    }
  }
}
