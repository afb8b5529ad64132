package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.geometry.Fix;
import org.starl.gvh.Wait;
import org.starl.id.RobotId;
import org.starl.robot.CreateWheelbase;
import org.starl.robot.create.Wheelbase;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.HostPort;
import org.starl.robot.file.Limits;
import org.starl.robot.file.Network;
import org.starl.robot.file.Positions;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.Wheels;
import org.starl.sim.Simulation;
import org.starl.trace.Instance;

/** One robot of a deployment, alone on the loopback interface. */
@Tag("realtime")
class RobotRunTest {

  private static final RobotId BOT0 = new RobotId("bot0");
  private static final Limits LIMITS = new Limits(300, 300, 500, 0.1, 200);
  private static final Wheels.Create CREATE =
      new Wheels.Create("create2", new Wheels.Device("none"), 115_200, null);

  /** In order. */
  private final List<String> happened = new CopyOnWriteArrayList<>();

  private Consumer<String> teller = line -> {};
  private Function<GlobalVarHolder, LogicThread> app = Brief::new;
  private @Nullable RobotRun run;

  @TempDir private Path folder;
  private Deployment deployment = deployment(1);

  @BeforeEach
  void findAPort() throws IOException {
    try (DatagramSocket free = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      deployment = deployment(free.getLocalPort());
    }
  }

  private static Deployment deployment(int port) {
    RobotEntry bot0 =
        new RobotEntry(BOT0, 1, new HostPort("127.0.0.1", port), CREATE, "bot0", List.of(), null);
    return new Deployment(
        "my.yaml",
        "brief",
        1,
        Map.of(),
        Map.of(),
        null,
        new Network(port, false, 1000, 3000, 0),
        new Positions.NatNet(new HostPort("127.0.0.1", 9), 1511, null, null, "4.1", true, 5, 0.02),
        new TreeMap<>(Map.of(BOT0, bot0)),
        null,
        LIMITS);
  }

  private RobotRun run(Wheelbase.Source wheels, int rounds) {
    return run(wheels, rounds, new ByteArrayOutputStream());
  }

  private RobotRun run(Wheelbase.Source wheels, int rounds, OutputStream trace) {
    RobotRun.Settings settings =
        new RobotRun.Settings(
            deployment,
            deployment.robot("bot0"),
            null,
            () -> Simulation.builder().robots(1, app).seed(1).build().plan(),
            wheels,
            folder.resolve("storage"),
            rounds);
    run =
        new RobotRun(
            settings,
            trace,
            line -> {
              happened.add(line);
              teller.accept(line);
            });
    return run;
  }

  private void stopAtTheEndOfTheRound() {
    teller =
        line -> {
          if (line.contains("end of round")) {
            run().stop();
          }
        };
  }

  private RobotRun run() {
    if (run == null) {
      throw new AssertionError("there is no run yet");
    }
    return run;
  }

  @Test
  void eachRoundOpensAndClosesItsWheels() throws IOException {
    teller =
        line -> {
          if (line.contains("end of round 3 of 3")) {
            run().stop();
          }
        };

    Throwable failure = run((strand, clock, log, onFailure) -> new Standing(), 3).run();

    assertThat(failure).isNull();
    assertThat(happened).filteredOn("wheels"::equals).hasSize(3);
    assertThat(happened).filteredOn("wheels closed"::equals).hasSize(3);
  }

  @Test
  void aRobotStoppedBetweenRoundsStartsNoOther() throws IOException {
    Standing wheels = new Standing();
    wheels.onClose = () -> run().stop();

    run((strand, clock, log, onFailure) -> wheels, 3).run();

    assertThat(happened).filteredOn("wheels closed"::equals).hasSize(1);
  }

  @Test
  void aRobotStoppedBeforeItBeginsOpensNoWheels() throws IOException {
    RobotRun early = run((strand, clock, log, onFailure) -> new Standing(), 1);
    early.stop();

    early.run();

    assertThat(happened).doesNotContain("wheels");
  }

  @Test
  void aStoppedRobotPrintsWhatItsAppWaitedFor() throws IOException {
    app = Endless::new;
    teller =
        line -> {
          if (line.endsWith("begins to wait")) {
            run().stop();
          }
        };

    run((strand, clock, log, onFailure) -> new Standing(), 1).run();

    assertThat(happened)
        .anyMatch(line ->
            line.matches(
                "bot0: not finished: bot0 waits at RobotRunTest.java:[0-9]+ .callStarL. for: a sign"
                    + " that never comes"))
        .contains("bot0:   test: holds [S] from [bot1]");
  }

  @Test
  void anEmergencyStopPrecedesItsMessage() throws IOException {
    stopAtTheEndOfTheRound();

    run((strand, clock, log, onFailure) -> new Standing(), 1).run();

    assertThat(happened).contains("bot0: wheels: emergency stop");
    assertThat(happened.indexOf("wheels stand"))
        .isBetween(0, happened.indexOf("bot0: wheels: emergency stop"));
  }

  @Test
  void aTraceThatCannotBeWrittenStopsTheWheelsAndEndsTheRunWithOneLine() throws IOException {
    Throwable failure =
        run(
                (strand, clock, log, onFailure) -> new Standing(),
                1,
                Files.newOutputStream(Path.of("/dev/full")))
            .run();

    assertThat(failure).hasMessageContaining("No space left");
    assertThat(happened)
        .filteredOn(line -> line.contains("wheels stopped"))
        .containsExactly(
            "bot0: wheels stopped: the trace cannot be written: No space left on device");
  }

  @Test
  void aTraceThatCannotBeClosedIsAFailureOfTheRun() throws IOException {
    stopAtTheEndOfTheRound();
    OutputStream trace =
        new ByteArrayOutputStream() {
          @Override
          public void close() throws IOException {
            throw new IOException("the disk is gone");
          }
        };

    Throwable failure = run((strand, clock, log, onFailure) -> new Standing(), 1, trace).run();

    assertThat(failure).hasMessageContaining("the disk is gone");
  }

  @Test
  void promisesThatCannotBeStoredStopTheWheelsAndEndTheRun() throws IOException {
    Path storage = Files.createDirectories(folder.resolve("storage"));
    Wheelbase.Source wheels =
        (strand, clock, log, onFailure) -> {
          // On the strand, so before the write of the boot number.
          strand.post(() -> fillAfterFirstWrite(storage));
          return new Standing();
        };

    assertThat(run(wheels, 1).run()).hasMessageContaining("No space left");
    assertThat(happened).contains("wheels stand");
    assertThat(happened)
        .filteredOn(line -> line.contains("wheels stopped"))
        .singleElement()
        .satisfies(line -> assertThat(line).startsWith("bot0: wheels stopped: " + storage));
  }

  private static void fillAfterFirstWrite(Path storage) {
    String[] files = storage.toFile().list();
    while (files == null || Arrays.stream(files).noneMatch(name -> name.endsWith(".value"))) {
      Thread.onSpinWait();
      files = storage.toFile().list();
    }
    try {
      Files.createSymbolicLink(storage.resolve("fresh.tmp"), Path.of("/dev/full"));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void aBugBelowTheProgramEndsTheRunAndIsReturned() throws IOException {
    IllegalStateException bug = new IllegalStateException("a bug");
    Wheelbase.Source create =
        CreateWheelbase.of(
            "bot0",
            CREATE,
            LIMITS,
            () -> {
              throw bug;
            });
    teller =
        line -> {
          if (line.contains("the driver has failed")) {
            run().stop();
          }
        };

    assertThat(run(create, 1).run()).isSameAs(bug);
  }

  /** Comes to its end at once. */
  private static final class Brief extends LogicThread {
    Brief(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      return List.of();
    }
  }

  /** Waits for ever. */
  private static final class Endless extends LogicThread {
    Endless(GlobalVarHolder gvh) {
      super(gvh);
      gvh.explain(() -> new Wait(Instance.of("test"), "holds [S]", List.of(new RobotId("bot1"))));
    }

    @Override
    public List<Object> callStarL() {
      gvh.log.i("app", "begins to wait");
      await("a sign that never comes", () -> false);
      return List.of();
    }
  }

  /** Wheels that do not turn. */
  private final class Standing implements Wheelbase {
    private Runnable onClose = () -> {};

    Standing() {
      happened.add("wheels");
    }

    @Override
    public void drive(WheelCommand command) {}

    @Override
    public Bumps bumps() {
      return Bumps.NONE;
    }

    @Override
    public void onBump(Runnable receiver) {}

    @Override
    public void fixed(Fix fix) {}

    @Override
    public void doubted() {}

    @Override
    public void emergencyStop() {
      happened.add("wheels stand");
    }

    @Override
    public void release() {}

    @Override
    public void close() {
      happened.add("wheels closed");
      onClose.run();
    }
  }
}
