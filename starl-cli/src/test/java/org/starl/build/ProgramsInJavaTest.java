package org.starl.build;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.StringWriter;
import java.lang.reflect.Constructor;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.lang.java.JavaSources;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.launch.StackTraces;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.SimulationFailed;
import org.starl.spec.Monitor;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;

/**
 * The Java of a program compiles without warnings and does what its source says. Public, because the
 * compiled program calls it.
 */
public class ProgramsInJavaTest {

  private static final String SHUTTLE =
      """
      // Drives to a point and back, alone.
      program Shuttle[PIDS, Zones, Places]
      java "x.Shuttle"
      java Places = "org.starl.geometry.ItemPosition"
      java fun dock: Zones = "org.starl.build.ProgramsInJavaTest.dock"
      java fun goal(who: PIDS, n: nat): Places = "org.starl.build.ProgramsInJavaTest.goal"
      type Mood = fresh | tired(trips: nat)
      given xid: Text, all: set[PIDS], most: nat
      uses reg: Registration(xid, all)
      uses mux: Mutex(xid, reg)
      uses moat: Motion
      fun isEnough(n: nat): bool = n >= 2
      state
        trips: nat := 0
        mood: Mood := fresh
      every 50 ms
      location S0
        do reg.do_register(); goto reg_wait
      location reg_wait
        when reg.registered do mux.do_mutex({dock}, reg.rList); goto mutex_wait
        when reg.failed do restart
      location mutex_wait
        when mux.crit do moat.do_move(goal(self, trips)); goto move_wait
        when mux.failed do goto reg_wait
      location move_wait
        when moat.done and trips < 1 do trips := trips + 1; moat.do_move(goal(self, trips)); goto move_wait
        when moat.done do mood := tired(trips); mux.release({dock}); goto leave
        when moat.failed do moat.do_move(goal(self, trips)); goto move_wait
      location leave
        do reg.unregister(); goto unreg_wait
      location unreg_wait
        when reg.unregistered and not self in reg.rList do goto done
        when reg.unregistered do goto done
        when reg.failed do goto leave
      location done
      """;

  @TempDir private Path folder;

  /** Called by the program. */
  public static String dock() {
    return "dock";
  }

  /** Called by the program. */
  public static ItemPosition goal(RobotId who, long n) {
    return new ItemPosition("goal" + n, 1000 * (n + 1), start(who).yMm());
  }

  /** Called by the program. */
  public static ItemPosition noGoal(RobotId who, long n) {
    throw new IllegalStateException("no goal " + n);
  }

  private static Point start(RobotId who) {
    return new Point(500, 600 * (1 + who.name().charAt(3) - '0'));
  }

  private Constructor<?> compiled(String text)
      throws SourceErrors, IOException, ReflectiveOperationException {
    List<String> files = new ArrayList<>();
    for (Map.Entry<String, String> each : sources(text).entrySet()) {
      Path path = folder.resolve(each.getKey());
      Files.createDirectories(path.getParent());
      files.add(Files.writeString(path, each.getValue()).toString());
    }
    var compiler = ToolProvider.getSystemJavaCompiler();
    StringWriter told = new StringWriter();
    try (var manager = compiler.getStandardFileManager(null, null, null)) {
      List<String> options =
          List.of("-d", folder.toString(), "-proc:none", "-Xlint:all", "-Werror");
      var units = manager.getJavaFileObjectsFromStrings(files);
      boolean isGood = compiler.getTask(told, manager, null, options, null, units).call();
      assertThat(isGood).as("%s%n%s", told, Files.readString(Path.of(files.getLast()))).isTrue();
    }
    // Not closed: classes are loaded while the program runs.
    ClassLoader loader = new URLClassLoader(new URL[] {folder.toUri().toURL()});
    return loader.loadClass("x.Shuttle").getConstructors()[0];
  }

  private static Map<String, String> sources(String text) throws SourceErrors, IOException {
    Path file = Files.createTempFile("shuttle", ".starl");
    try {
      return JavaSources.of(
          new SourceReader().source(Files.writeString(file, text)), "Shuttle.starl");
    } finally {
      Files.delete(file);
    }
  }

  private static LogicThread made(Constructor<?> program, GlobalVarHolder gvh) {
    try {
      return (LogicThread) program.newInstance(gvh, "dock", gvh.id.participants(), 2L);
    } catch (ReflectiveOperationException e) {
      throw new AssertionError(e);
    }
  }

  private SimResult run(String text, long seed, List<TraceEvent> events) throws Exception {
    return run(text, seed, events, new MutexSpec().only("dock"));
  }

  private SimResult run(String text, long seed, List<TraceEvent> events, Monitor monitor)
      throws Exception {
    Constructor<?> program = compiled(text);
    Simulation.Builder simulation = Simulation.builder();
    for (RobotId id : List.of(new RobotId("bot0"), new RobotId("bot1"), new RobotId("bot2"))) {
      simulation.robot(new RobotSpec(id, Pose.of(start(id), 0), true, gvh -> made(program, gvh)));
    }
    return simulation
        .monitor(() -> monitor)
        .monitor(RegistrationSpec::new)
        .observer(
            new SimObserver() {
              @Override
              public void observed(TraceEvent event) {
                events.add(event);
              }
            })
        .settings(SimSettings.builder().set("messageLoss", "0.2").build())
        .endNs(120_000_000_000L)
        .seed(seed)
        .build()
        .run();
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void robotsDoWhatTheirProgramSays(long seed) throws Exception {
    List<TraceEvent> events = new ArrayList<>();
    SimResult result = run(SHUTTLE, seed, events);
    assertThat(result.isFinished()).as("%s", result.unfinished()).isTrue();
    assertThat(result.spec().violations()).isEmpty();
    assertThat(events)
        .filteredOn(each -> each.robot().name().equals("bot1"))
        .filteredOn(TraceEvent.Variable.class::isInstance)
        .map(TraceEvent.Variable.class::cast)
        .filteredOn(each -> each.source().equals(Instance.APP))
        .extracting(each -> each.name() + "=" + each.value())
        .containsSubsequence(
            "location=S0",
            "trips=0",
            "location=REG_WAIT",
            "location=MUTEX_WAIT",
            "location=MOVE_WAIT",
            "trips=1",
            "mood=tired(1)",
            "location=LEAVE",
            "location=UNREG_WAIT",
            "location=DONE");
  }

  @Test
  void aProgramThatWaitsNamesTheLineOfItsLocation() throws Exception {
    String stuck = SHUTTLE.replace("when mux.crit do", "when mux.crit and isEnough(trips) do");
    SimResult result = run(stuck, 1, new ArrayList<>());
    assertThat(result.unfinished()).hasSize(3);
    assertThat(result.diagnosis().lines())
        .as("%s", result.diagnosis().lines())
        .anyMatch(line -> line.contains("app: MUTEX_WAIT, Shuttle.starl:22"))
        .anyMatch(line -> line.contains("bot0 waits at Shuttle.starl:22 (callStarL)"));
  }

  /** No robot may move. */
  private static final class Standing implements Monitor {
    @Override
    public List<String> lemmas() {
      return List.of("standing");
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      if (event instanceof TraceEvent.Variable it && it.value().toString().equals("MOVE_WAIT")) {
        report.violated("standing", event.timeNs(), List.of(event.robot()), "moves");
      }
    }
  }

  @Test
  void aViolationNamesTheLineOfItsBranch() throws Exception {
    SimResult result = run(SHUTTLE, 1, new ArrayList<>(), new Standing());
    assertThat(result.diagnosis(result.spec().violations().get(0)).lines())
        .first()
        .asString()
        .matches("  bot\\d runs at Shuttle.starl:23 .callStarL.");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          when mux.crit do moat.do_move(goal(self, trips)) | when mux.crit do moat.do_move(broken(self, trips)) | 23
          when mux.failed do goto reg_wait | when broken(self, trips) = goal(self, 0) do goto reg_wait | 22
          do reg.unregister() | do moat.do_move(broken(self, trips)); reg.unregister() | 30
          """)
  void anExceptionOfAProgramNamesTheLineOfItsBranchOrForAGuardOfItsLocation(
      String right, String wrong, int line) {
    String declared = "java fun goal(who: PIDS, n: nat): Places =";
    String broken =
        SHUTTLE
            .replace(right, wrong)
            .replace(
                declared,
                declared.replace("goal", "broken")
                    + " \"org.starl.build.ProgramsInJavaTest.noGoal\"\n"
                    + declared)
            .replace("// Drives to a point and back, alone.\n", ""); // for the line more
    assertThatThrownBy(() -> run(broken, 1, new ArrayList<>()))
        .isInstanceOf(SimulationFailed.class)
        .hasMessageContaining("IllegalStateException: no goal")
        .hasMessageEndingWith("; at Shuttle.starl:" + line + " (callStarL)")
        .rootCause()
        .satisfies(cause ->
            assertThat(StackTraces.of(cause))
                .contains(
                    "org.starl.build.ProgramsInJavaTest.noGoal(ProgramsInJavaTest.java:",
                    "x.Shuttle.callStarL(Shuttle.starl:" + line + ")")
                .doesNotContain("Shuttle.java"));
  }

  @Test
  void equalSourcesGiveEqualFiles() throws Exception {
    assertThat(sources(SHUTTLE)).isEqualTo(sources(SHUTTLE)).containsOnlyKeys("x/Shuttle.java");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          java "x.Shuttle" | java "Shuttle" | 2:1: 'Shuttle' is no Java class; expected a line: java "a.package.Name"
          java "x.Shuttle" |  | 2:1: program 'Shuttle' names no Java class; expected a line: java "a.package.Name"
          mutex_wait | REG_WAIT | 22:1: 'REG_WAIT' and 'reg_wait' have one name in Java; expected names that differ in more than the size of letters
          """)
  void whatHasNoJavaIsToldWithItsPlace(String right, String wrong, String error) {
    String changed = SHUTTLE.replace(right, wrong == null ? "" : wrong);
    assertThatThrownBy(() -> sources(changed))
        .isInstanceOf(SourceErrors.class)
        .hasMessage("Shuttle.starl:" + error);
  }
}
