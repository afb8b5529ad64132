package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.geometry.Fix;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.robot.LocalSpecs;
import org.starl.robot.create.Wheelbase;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.HostPort;
import org.starl.robot.file.Limits;
import org.starl.robot.file.Network;
import org.starl.robot.file.Positions;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.Wheels;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.SimulationPlan;
import org.starl.spec.Monitor;
import org.starl.spec.SpecReport.Violation;
import org.starl.trace.Instance;
import org.starl.trace.Note;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Moved;

/** A robot that violates a specification by itself stops. */
@Tag("realtime")
class LocalSpecsTest {

  private static final RobotId BOT = new RobotId("bot0");

  @TempDir private Path folder;

  /** Once: no robot enters twice. Invited, over all robots: another robot has invited it. */
  private static final class Entrances implements Monitor {
    private boolean isInside;

    @Override
    public List<String> lemmas() {
      return List.of("Once", "Invited");
    }

    @Override
    public List<String> perRobotLemmas() {
      return List.of("Once");
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      if (event instanceof Joined || event instanceof Moved) {
        report.violated("Once", event.timeNs(), List.of(event.robot()), "has a body");
      }
      if (event instanceof Action action && action.name().equals("enter")) {
        report.checked("Once");
        report.violated("Invited", action.timeNs(), List.of(action.robot()), "by nobody");
        if (isInside) {
          report.violated("Once", action.timeNs(), List.of(action.robot()), "is inside already");
        }
        isInside = true;
      }
    }
  }

  /** Enters twice. */
  private static final class Buggy extends LogicThread {
    Buggy(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      gvh.trace.action("door", "enter");
      sleep(1);
      gvh.trace.action("door", "enter");
      sleep(3_600_000);
      return List.of();
    }
  }

  private static SimulationPlan plan() {
    return Simulation.builder()
        .name("doors")
        .settings(SimSettings.defaults())
        .robots(1, Buggy::new)
        .monitor(Entrances::new)
        .build()
        .plan();
  }

  /** Wheels that count how often they were stopped. */
  private static final class StillWheels implements Wheelbase {
    private final AtomicInteger stops = new AtomicInteger();

    @Override
    public void drive(WheelCommand command) {
      // They stand still.
    }

    @Override
    public Bumps bumps() {
      return Bumps.NONE;
    }

    @Override
    public void onBump(Runnable receiver) {
      // Nobody is there.
    }

    @Override
    public void fixed(Fix fix) {
      // Nobody measures.
    }

    @Override
    public void doubted() {}

    @Override
    public void emergencyStop() {
      stops.incrementAndGet();
    }

    @Override
    public void release() {
      throw new AssertionError("nobody releases them");
    }

    @Override
    public void close() {
      // Nothing is open.
    }
  }

  private static Deployment deployment() {
    RobotEntry entry =
        new RobotEntry(
            BOT,
            1,
            new HostPort("127.0.0.1", 0),
            new Wheels.Create("create2", new Wheels.Device("none"), 115_200, null),
            "bot0",
            List.of(),
            null);
    return new Deployment(
        "my.yaml",
        "doors",
        7,
        Map.of(),
        Map.of(),
        null,
        new Network(4747, false, 1000, 3000, 0),
        new Positions.JsonFeed(0, null, null, null, 5, 0.02),
        new TreeMap<>(Map.of(BOT, entry)),
        null,
        new Limits(300, 300, 500, 0.1, 200));
  }

  @Test
  void aRobotThatViolatesALemmaStopsItsWheelsEndsAndReportsIt() throws IOException {
    StillWheels wheels = new StillWheels();
    List<String> told = Collections.synchronizedList(new ArrayList<>());
    ByteArrayOutputStream trace = new ByteArrayOutputStream();
    Deployment deployment = deployment();
    RobotRun run =
        new RobotRun(
            new RobotRun.Settings(
                deployment,
                deployment.robot("bot0"),
                null,
                LocalSpecsTest::plan,
                (strand, clock, log, onFailure) -> wheels,
                folder,
                1),
            trace,
            told::add);

    Throwable failure = run.run();

    assertThat(failure).hasMessageStartingWith("VIOLATED: Once");
    assertThat(wheels.stops.get()).isPositive();
    assertThat(told)
        .filteredOn(line -> line.contains("VIOLATED"))
        .singleElement()
        .asString()
        .matches("bot0: wheels stopped: VIOLATED: Once violated at \\d+\\.\\d{3} s by bot0: .*");
    assertThat(trace.toString(StandardCharsets.UTF_8)).contains("\"kind\":\"end\"");
  }

  private static Action action(long timeNs) {
    return Action.of(timeNs, BOT, Instance.of("door"), Note.SHAPE, new Note("enter", List.of()));
  }

  @Test
  void lemmasOnOtherRobotsOrBodiesAreNotChecked() {
    List<Violation> violations = new ArrayList<>();
    LocalSpecs specs = new LocalSpecs(plan().monitors(), 1000, violations::add);

    specs.observed(new Joined(1100, BOT, new Pose(0, 0, 0), 165));
    specs.observed(action(1200));
    assertThat(violations).isEmpty();

    specs.observed(action(1300));
    assertThat(specs.lemmas()).containsExactly("Once");
    assertThat(violations)
        .containsExactly(new Violation("Once", 300, List.of(BOT), "is inside already"));
  }
}
