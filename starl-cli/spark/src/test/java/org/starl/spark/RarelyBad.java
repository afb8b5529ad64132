package org.starl.spark;

import java.util.List;
import org.starl.apps.Demo;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.hello.HelloDemo;
import org.starl.sim.SimSettings;
import org.starl.sim.fault.Envelope;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;

/** Hello with a specification that it violates in one of so many seeds: no robot drives. */
public final class RarelyBad implements Demo {

  private static final Demo HELLO = new HelloDemo();

  @Override
  public String name() {
    return "rarely-bad";
  }

  @Override
  public String summary() {
    return "Hello that is bad with one seed of so many.";
  }

  @Override
  public Envelope envelope() {
    return HELLO.envelope();
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(new Parameter("one-of", "10000", "seeds for each bad one"));
  }

  @Override
  public SimSettings.Builder defaultSettings(Request request) {
    return HELLO.defaultSettings(request);
  }

  @Override
  public Plan plan(Request request, SimSettings settings) {
    Plan plan = HELLO.plan(request, settings);
    if (request.seed() % Long.parseLong(request.parameter("one-of")) == 17) {
      plan.simulation().monitor(StandsStill::new);
    }
    return plan;
  }

  private static final class StandsStill implements Monitor {
    @Override
    public List<String> lemmas() {
      return List.of("stands_still");
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      if (event instanceof TraceEvent.Moved moved && moved.linearMmPerS() != 0) {
        report.violated("stands_still", event.timeNs(), List.of(event.robot()), "drives");
      }
    }
  }
}
