package org.starl.apps.intersection;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.starl.apps.intersection.robot.Car;
import org.starl.apps.intersection.robot.CarProgram;
import org.starl.apps.intersection.robot.Floor;
import org.starl.apps.intersection.robot.IntersectionFactory;
import org.starl.apps.intersection.spec.IntersectionSpec;
import org.starl.random.Rng;
import org.starl.sim.SimSettings;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;

/** All monitors of an intersection, over the events of one run of four cars. */
@State(Scope.Thread)
public class MonitorBenchmark {

  private static final int CARS = 4;

  private final List<TraceEvent> events = new ArrayList<>();
  private List<Supplier<? extends Monitor>> monitors = List.of();

  /** Records the events of a run. */
  @Setup
  public void record() {
    SimSettings settings = SimSettings.builder().set("messageLoss", "0.3").build();
    List<Car> cars = Car.drawn(settings.robotName(), CARS, new Rng(1).fork("cars"));
    new IntersectionPlan(Floor.kerbs(), settings, CarProgram.PAPER)
        .closed(cars)
        .simulation()
        .seed(1)
        .monitor(Recorder::new)
        .build()
        .run();
    monitors =
        new IntersectionSpec(IntersectionPlan.deltaNs(settings), CARS, 0, IntersectionSpec.STOPPING_NS)
            .monitors(IntersectionFactory.XID);
  }

  /** The monitors of a new run see its events. */
  @Benchmark
  public SpecReport observe() {
    Monitors fresh = Monitors.of(monitors);
    events.forEach(fresh::observe);
    fresh.finish(events.getLast().timeNs());
    return fresh.report();
  }

  /** Keeps what monitors see. */
  private final class Recorder implements Monitor {

    @Override
    public List<String> lemmas() {
      return List.of();
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      events.add(event);
    }
  }
}
