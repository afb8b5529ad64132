package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import java.util.function.Predicate;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.id.RobotId;
import org.starl.robot.DeployedRobot;
import org.starl.robot.trace.ProcessFact;
import org.starl.robot.trace.ProcessTrace;
import org.starl.sim.SimObserver;
import org.starl.sim.Simulation;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceHeader;

/** Traces are read while robots write them. */
@Tag("realtime")
class LiveTracesTest {

  private static final long S = 1_000_000_000;
  private static final RobotId A = new RobotId("bot0");
  private static final RobotId B = new RobotId("bot1");
  private static final TraceHeader HEADER =
      new TraceHeader("0", "x", 7, 8, Map.of(), List.of(A, B));

  @TempDir Path folder;

  private final BlockingQueue<TraceEvent> seen = new LinkedBlockingQueue<>();

  /** The time of the reader, which stands unless a test sets it. */
  private final AtomicLong realNs = new AtomicLong();

  /** A robot's process that begins at {@code machineNs}. */
  private ProcessTrace begun(RobotId robot, long machineNs) throws Exception {
    OutputStream out = Files.newOutputStream(folder.resolve(robot + ".trace"));
    ProcessTrace trace = new ProcessTrace(robot, HEADER, out);
    ProcessFact clock = new ProcessFact.Clock("this machine", machineNs, machineNs);
    trace.record(Action.of(0, robot, ProcessFact.SOURCE, ProcessFact.SHAPE, clock));
    return trace;
  }

  private static TraceEvent event(RobotId robot, long atNs, String name) {
    return new Fault(atNs, robot, name, "");
  }

  private Fault await(Predicate<Fault> wanted) throws InterruptedException {
    while (true) {
      TraceEvent next = seen.poll(60, TimeUnit.SECONDS);
      assertThat(next).as("an event that was written").isNotNull();
      if (next instanceof Fault fault && wanted.test(fault)) {
        return fault;
      }
    }
  }

  private LiveTraces reading(LongSupplier clock) {
    SimObserver observer =
        new SimObserver() {
          @Override
          public void observed(TraceEvent event) {
            seen.add(event);
          }
        };
    LiveMerge merge = new LiveMerge(Simulation.builder().build().plan(), List.of(observer));
    return new LiveTraces(
        folder, header -> DeployedRobot.VOCABULARY, HEADER, merge, line -> {}, clock);
  }

  @Test
  void whatARobotWritesIsSeenAndItsSilenceToo() throws Exception {
    ProcessTrace first = begun(A, 100 * S);
    try (LiveTraces traces = reading(realNs::get)) {
      assertThat(traces).isNotNull();
      first.record(event(A, S, "one"));
      ProcessTrace second = begun(B, 101 * S); // begins later, on the same clock
      second.record(event(B, S, "two"));
      first.record(event(A, 3 * S, "three"));
      assertThat(await(fault -> fault.name().equals("one")).timeNs()).isEqualTo(S);
      assertThat(await(fault -> fault.name().equals("two")).timeNs()).isEqualTo(2 * S);
      first.end(4 * S);
      realNs.set(7 * S); // the second is killed
      Fault crash = await(fault -> fault.name().equals(Fault.CRASH));
      assertThat(crash.robot()).isEqualTo(B);
      assertThat(crash.timeNs()).isEqualTo(7 * S);
    }
  }

  /** As when the machine slept: the clock has gone on since the reader saw the end of the file. */
  @Test
  void whatWasWrittenSinceTheLastLookIsNoSilence() throws Exception {
    ProcessTrace trace = begun(A, 100 * S);
    AtomicBoolean sleeps = new AtomicBoolean();
    CountDownLatch woke = new CountDownLatch(1);
    LongSupplier clock =
        () -> {
          if (sleeps.getAndSet(false)) {
            trace.record(event(A, 6 * S, "two"));
            realNs.set(20 * S);
            woke.countDown();
          }
          return realNs.get();
        };
    try (LiveTraces traces = reading(clock)) {
      assertThat(traces).isNotNull();
      trace.record(event(A, S, "one"));
      trace.record(event(A, 5 * S, "its time passes"));
      await(fault -> fault.name().equals("one"));
      sleeps.set(true);
      woke.await();
      trace.record(event(A, 30 * S, "three"));
      trace.record(event(A, 40 * S, "its time passes"));
      Fault next = await(fault -> fault.name().equals(Fault.CRASH) || fault.name().equals("three"));
      assertThat(next.name()).isEqualTo("three");
    }
  }

  @Test
  void allRobotsMayFallSilent() throws Exception {
    begun(A, 100 * S).record(event(A, S, "one"));
    begun(B, 100 * S).record(event(B, S, "two"));
    try (LiveTraces traces = reading(() -> realNs.addAndGet(S))) {
      assertThat(traces).isNotNull();
      RobotId first = await(fault -> fault.name().equals(Fault.CRASH)).robot();
      assertThat(await(fault -> fault.name().equals(Fault.CRASH)).robot()).isNotEqualTo(first);
    }
  }

  @Test
  void aClockThatIsAheadMakesNoOtherRobotSilent() throws Exception {
    begun(A, 100 * S);
    ProcessTrace ahead = begun(B, 100 * S);
    try (LiveTraces traces = reading(realNs::get)) {
      assertThat(traces).isNotNull();
      ahead.record(event(B, 60 * S, "one"));
      ahead.record(event(B, 62 * S, "two"));
      Fault next = await(fault -> fault.name().equals(Fault.CRASH) || fault.name().equals("one"));
      assertThat(next.name()).isEqualTo("one");
    }
  }
}
