package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.comms.Codec;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.robot.DeployedRobot;
import org.starl.robot.MeasuredBody;
import org.starl.robot.MeasuredBody.Within;
import org.starl.robot.trace.ProcessFact;
import org.starl.robot.trace.ProcessTrace;
import org.starl.sim.Failure;
import org.starl.sim.SimObserver;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.SimulationPlan;
import org.starl.sim.TraceRecorder;
import org.starl.spec.Bodies;
import org.starl.spec.Monitor;
import org.starl.spec.SpecReport.Violation;
import org.starl.trace.Instance;
import org.starl.trace.Note;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceHeader;

/** The traces of several processes as one. */
class TraceMergeTest {

  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");
  private static final long MS = 1_000_000;
  private static final long SECOND = 1000 * MS;
  private static final TraceHeader HEADER =
      new TraceHeader("test", "section", 1, 1, Map.of(), List.of(A, B));

  private static final Instance CHANNEL = Instance.of("p", "i");

  @TempDir private Path folder;

  /** No two robots are in the section. */
  private static final class Exclusion implements Monitor {
    private final Map<RobotId, Boolean> inside = new TreeMap<>();

    @Override
    public List<String> lemmas() {
      return List.of("Exclusion");
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      if (event instanceof Action action) {
        report.checked("Exclusion");
        if (action.name().equals("leave")) {
          inside.remove(action.robot());
        } else if (action.name().equals("enter")) {
          inside.put(action.robot(), true);
          if (inside.size() > 1) {
            report.violated(
                "Exclusion", action.timeNs(), List.copyOf(inside.keySet()), "two inside");
          }
        }
      }
    }
  }

  /** No two bodies touch. */
  private static final class Apart implements Monitor {
    private final Bodies bodies = new Bodies();

    @Override
    public List<String> lemmas() {
      return List.of("Apart");
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      bodies.observe(event);
      if (bodies.robots().size() == 2) {
        report.checked("Apart");
        double distanceMm =
            bodies.poseAt(A, event.timeNs()).at().distanceMm(bodies.poseAt(B, event.timeNs()).at());
        if (distanceMm < bodies.radiusMm(A) + bodies.radiusMm(B)) {
          report.violated("Apart", event.timeNs(), List.of(A, B), "touch");
        }
      }
    }
  }

  private static SimulationPlan plan() {
    return Simulation.builder()
        .name("section")
        .settings(SimSettings.defaults())
        .monitor(Exclusion::new)
        .monitor(Apart::new)
        .build()
        .plan();
  }

  private static Action action(long atMs, RobotId robot, String name) {
    return Action.of(atMs * MS, robot, Instance.APP, Note.SHAPE, new Note(name, List.of()));
  }

  private static Sent sent(long atMs, RobotId robot, long number) {
    return new Sent(atMs * MS, robot, "*", CHANNEL, number, 10, Codec.text(), "hello");
  }

  private static Delivered delivered(long atMs, RobotId robot, RobotId from, long number) {
    return new Delivered(atMs * MS, robot, from, CHANNEL, number, Codec.text(), "hello");
  }

  private String trace(
      RobotId robot, String machine, long machineNs, long dateNs, TraceEvent... events)
      throws IOException {
    return trace(robot, robot + ".trace", machine, machineNs, dateNs, true, events);
  }

  private String trace(
      RobotId robot,
      String name,
      String machine,
      long machineNs,
      long dateNs,
      boolean isWhole,
      TraceEvent... events)
      throws IOException {
    Path file = folder.resolve(name);
    try (OutputStream out = Files.newOutputStream(file)) {
      ProcessTrace trace = new ProcessTrace(robot, HEADER, out);
      trace.report(() -> 0, new ProcessFact.Clock(machine, machineNs, dateNs));
      Arrays.asList(events).forEach(trace::record);
      if (isWhole) {
        trace.end(events.length == 0 ? 0 : events[events.length - 1].timeNs());
      }
    }
    return file.toString();
  }

  @Test
  void aMissingStartIsNamedAndItsViolationsAreOnlyPossible() throws IOException {
    String first =
        trace(A, "a.trace", "m", 0, 0, true, action(1, A, "enter"), action(2, A, "leave"));
    String third = trace(A, "a.3.trace", "m", 2 * SECOND, 2 * SECOND, true, action(3, A, "enter"));
    String other = trace(B, "m", 0, 0, action(2004, B, "enter"));

    TraceMerge.Result result = judge(0, first, third, other);

    assertThat(result.violations()).isEmpty();
    assertThat(result.possible()).hasSize(1);
    assertThat(result.undecided()).containsExactly("Exclusion");
    assertThat(result.missing())
        .singleElement()
        .asString()
        .contains("a.3.trace: start 3 of a without its start 2");

    String second = trace(A, "a.2.trace", "m", SECOND, SECOND, true, action(1, A, "look"));
    assertThat(judge(0, first, second, third, other).violations()).hasSize(1);
  }

  @Test
  void aTraceGivenTwiceIsRefused() throws IOException {
    String file = trace(A, "m", 0, 0, action(1, A, "enter"));
    Path copy = Files.copy(Path.of(file), folder.resolve("copy.trace"));

    assertThatThrownBy(() -> judge(0, file, copy.toString()))
        .isInstanceOf(BadInput.class)
        .hasMessage(copy + ": the same start of a as " + file + "; give one");
  }

  @Test
  void itsOwnOutputAmongTheInputsIsNamed() throws IOException {
    String file = trace(A, "m", 0, 0, action(1, A, "enter"));
    Path merged = folder.resolve("merged.trace");
    try (TraceRecorder out = new TraceRecorder(Files.newOutputStream(merged))) {
      merge(List.of(file), 0, 0).judge(plan(), List.of(out));
    }

    assertThatThrownBy(() -> judge(0, file, merged.toString()))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining(merged + ": is the output of 'starl deploy merge'");
  }

  private static TraceMerge merge(List<String> files, long dateErrorNs, long driftPpm) {
    return TraceMerge.of(files, header -> DeployedRobot.VOCABULARY, dateErrorNs, driftPpm);
  }

  private static TraceMerge.Result judge(long dateErrorNs, String... files) {
    return merge(List.of(files), dateErrorNs, 0).judge(plan(), List.of());
  }

  private static List<String> order(long dateErrorNs, String... files) {
    List<String> seen = new ArrayList<>();
    merge(List.of(files), dateErrorNs, 0)
        .judge(
            plan(),
            List.of(
                new SimObserver() {
                  @Override
                  public void observed(TraceEvent event) {
                    if (event instanceof Action action) {
                      seen.add(action.robot() + " " + action.name());
                    }
                  }
                }));
    return seen;
  }

  @Test
  void tracesOfOneMachineAreOrderedByItsClock() throws IOException {
    String a = trace(A, "m", 5 * SECOND, 0, action(10, A, "enter"), action(20, A, "leave"));
    String b = trace(B, "m", 5 * SECOND, 9 * SECOND, action(15, B, "enter"));

    TraceMerge.Result result = judge(SECOND, a, b);

    assertThat(result.orders()).isEqualTo(1);
    assertThat(result.violations()).hasSize(1);
    assertThat(result.possible()).isEmpty();
    assertThat(order(SECOND, a, b)).containsExactly("a enter", "b enter", "a leave");
  }

  @Test
  void aViolationInSomeOrdersOnlyIsPossible() throws IOException {
    String a = trace(A, "m", 0, 0, action(10, A, "enter"), action(20, A, "leave"));
    String b = trace(B, "n", 70 * SECOND, 0, action(25, B, "enter"));

    TraceMerge.Result result = judge(100 * MS, a, b);

    assertThat(result.violations()).isEmpty();
    assertThat(result.possible()).hasSize(1);
    assertThat(result.uncertaintyNs()).isEqualTo(200 * MS);
  }

  @Test
  void aViolationInEveryOrderIsCertain() throws IOException {
    String a = trace(A, "m", 0, 0, action(1000, A, "enter"), action(9000, A, "leave"));
    String b = trace(B, "n", 0, 0, action(5000, B, "enter"));

    assertThat(judge(100 * MS, a, b).violations()).hasSize(1);
  }

  @Test
  void whatWentWrongIsDescribedToObserversAndInTheResult() throws IOException {
    String a = trace(A, "m", 0, 0, joined(10, A, 0), action(1000, A, "enter"));
    String b = trace(B, "b.trace", "m", 0, 0, false, joined(10, B, 900), action(500, B, "enter"));
    List<Failure> told = new ArrayList<>();
    List<Violation> violations = new ArrayList<>();
    SimObserver observer =
        new SimObserver() {
          @Override
          public void wentWrong(Failure failure) {
            told.add(failure);
          }

          @Override
          public void violated(Violation violation) {
            violations.add(violation);
          }
        };

    TraceMerge.Result result = merge(List.of(a, b), SECOND, 0).judge(plan(), List.of(observer));

    Failure failure = Objects.requireNonNull(result.failure());
    assertThat(told).containsExactly(failure);
    assertThat(violations).containsExactlyElementsOf(result.violations());
    assertThat(failure.headline()).isEqualTo(result.violations().getFirst().toString());
    assertThat(failure.robots()).containsExactly(A, B);
    assertThat(failure.culprits().getLast().truth()).isEqualTo(new Pose(900, 0, 0));
    assertThat(failure.faults()).singleElement().asString().contains("b", "crash");
    assertThat(result.run().faults()).isEqualTo(failure.faults());
  }

  @Test
  void messagesOrderEventsThatClocksDoNot() throws IOException {
    // By their dates b would enter first; a has left before it has sent what b waits for.
    String a =
        trace(A, "m", 0, 0, action(100, A, "enter"), action(200, A, "leave"), sent(210, A, 1));
    String b = trace(B, "n", 0, 0, delivered(150, B, A, 1), action(160, B, "enter"));

    TraceMerge.Result result = judge(100 * MS, a, b);

    assertThat(result.violations()).isEmpty();
    assertThat(result.possible()).isEmpty();
    assertThat(order(100 * MS, a, b)).containsExactly("a enter", "a leave", "b enter");
  }

  @Test
  void noEventComesBeforeItsCauseWhenClocksDrift() throws IOException {
    String a =
        trace(A, "m", 0, 0, action(100, A, "enter"), action(200, A, "leave"), sent(210, A, 1));
    String b = trace(B, "n", 0, 0, delivered(150, B, A, 1), action(160, B, "enter"));

    TraceMerge.Result result = merge(List.of(a, b), 100 * MS, 1_000_000).judge(plan(), List.of());

    assertThat(result.orders()).isEqualTo(5);
    assertThat(result.violations()).isEmpty();
    assertThat(result.possible()).isEmpty();
  }

  @Test
  void contradictoryClocksAreRefused() throws IOException {
    String a = trace(A, "m", 0, 0, sent(5000, A, 1));
    String b = trace(B, "n", 0, 0, delivered(100, B, A, 1));

    assertThatThrownBy(() -> judge(100 * MS, a, b))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining("contradicts");
  }

  @Test
  void aKilledProcessIsACrash() throws IOException {
    String a = trace(A, "m", 0, 0, action(10, A, "enter"));
    String b = trace(B, "b.trace", "m", 0, 0, false, action(15, B, "look"));
    List<TraceEvent> faults = new ArrayList<>();

    TraceMerge.Result result =
        merge(List.of(a, b), SECOND, 0)
            .judge(
                plan(),
                List.of(
                    new SimObserver() {
                      @Override
                      public void observed(TraceEvent event) {
                        if (event instanceof Fault fault && fault.name().equals(Fault.CRASH)) {
                          faults.add(fault);
                        }
                      }
                    }));

    assertThat(result.dead()).containsExactly(B);
    assertThat(faults).containsExactly(new Fault(15 * MS, B, Fault.CRASH, ""));
  }

  private static Joined joined(long atMs, RobotId robot, double xMm) {
    return new Joined(atMs * MS, robot, new Pose(xMm, 0, 0), 100);
  }

  private static Moved measured(long atMs, RobotId robot, double xMm) {
    return new Moved(atMs * MS, robot, new Pose(xMm, 0, 0), 0, 0);
  }

  private static Action within(long atMs, RobotId robot, int mm) {
    return Action.of(atMs * MS, robot, MeasuredBody.SOURCE, Within.SHAPE, new Within(mm));
  }

  /** Two discs of 100 mm, the second measured so far from the first, each within 10 mm. */
  private TraceMerge.Result measuredApart(double mm) throws IOException {
    String a = trace(A, "m", 0, 0, joined(10, A, 0), within(20, A, 10));
    String b = trace(B, "m", 0, 0, joined(10, B, 1000), within(20, B, 10), measured(30, B, mm));
    return judge(SECOND, a, b);
  }

  @Test
  void bodiesThatTouchInAllCasesAreAViolation() throws IOException {
    TraceMerge.Result result = measuredApart(179);

    assertThat(result.withinMm()).isEqualTo(10);
    assertThat(result.violations()).hasSize(1);
    assertThat(result.possible()).isEmpty();
  }

  @Test
  void bodiesThatTouchInSomeCasesAreAPossibleViolation() throws IOException {
    for (double mm : new double[] {181, 200, 219}) {
      TraceMerge.Result result = measuredApart(mm);
      assertThat(result.violations()).as("%s mm", mm).isEmpty();
      assertThat(result.possible()).as("%s mm", mm).hasSize(1);
    }
    assertThat(measuredApart(221).possible()).isEmpty();
  }

  @Test
  void trueBodiesOfTheWorldReplaceMeasuredOnes() throws IOException {
    String world = trace(Fault.WORLD, "m", 0, 0, joined(5, B, 1000), measured(30, B, 201));
    String a = trace(A, "m", 0, 0, joined(10, A, 0));
    String b = trace(B, "m", 0, 0, joined(10, B, 1000), within(20, B, 10), measured(30, B, 50));

    TraceMerge.Result result = judge(SECOND, world, a, b);

    assertThat(result.withinMm()).isZero();
    assertThat(result.violations()).isEmpty();
    assertThat(result.possible()).isEmpty();
  }

  @Test
  void aBodyJoinsOnceHoweverOftenItsProgramStarts() throws IOException {
    String a = trace(A, "a.trace", "m", 0, 0, false, joined(10, A, 0));
    String again = trace(A, "a.2.trace", "m", 0, 100 * MS, true, joined(100, A, 50));
    List<TraceEvent> seen = new ArrayList<>();

    merge(List.of(again, a), SECOND, 0)
        .judge(
            plan(),
            List.of(
                new SimObserver() {
                  @Override
                  public void observed(TraceEvent event) {
                    if (event instanceof Joined || event instanceof Moved) {
                      seen.add(event);
                    }
                  }
                }));

    assertThat(seen).containsExactly(joined(10, A, 0), measured(100, A, 50));
  }

  @Test
  void headersMayLackSettingsButNotContradict() throws IOException {
    String phone = headed("phone", Map.of("scenario", "figure7"));
    String board = headed("board", Map.of("scenario", "figure7", "debris", "0"));
    String other = headed("other", Map.of("scenario", "figure7", "debris", "1"));

    assertThat(merge(List.of(phone, board), SECOND, 0).header().settings())
        .containsExactly(Map.entry("scenario", "figure7"));
    assertThatThrownBy(() -> merge(List.of(phone, board, other), SECOND, 0))
        .isInstanceOf(BadInput.class)
        .hasMessageEndingWith("other.trace:1: its header differs; expected the header of " + board);
  }

  private String headed(String name, Map<String, String> settings) throws IOException {
    Path file = folder.resolve(name + ".trace");
    try (OutputStream out = Files.newOutputStream(file)) {
      TraceHeader header = new TraceHeader("test", "section", 1, 1, settings, List.of(A, B));
      ProcessTrace trace = new ProcessTrace(A, header, out);
      trace.report(() -> 0, new ProcessFact.Clock("m", 0, 0));
      trace.end(0);
    }
    return file.toString();
  }

  @Test
  void aFileThatIsNotADeploymentTraceIsRefused() throws IOException {
    Path file = folder.resolve("other.trace");
    try (OutputStream out = Files.newOutputStream(file)) {
      new ProcessTrace(A, HEADER, out).end(0);
    }

    assertThatThrownBy(() -> judge(SECOND, file.toString()))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining("does not name its clock");
    assertThatThrownBy(() -> judge(SECOND, folder.resolve("none.trace").toString()))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining("no such file");
  }
}
