package org.starl.apps.intersection;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.function.BiConsumer;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.intersection.logic.CrossingFact.Way;
import org.starl.apps.intersection.logic.IntersectionApp;
import org.starl.apps.intersection.robot.Car;
import org.starl.apps.intersection.robot.CarProgram;
import org.starl.apps.intersection.robot.Floor;
import org.starl.apps.intersection.robot.IntersectionFactory;
import org.starl.apps.intersection.spec.IntersectionSpec;
import org.starl.apps.intersection.spec.TrafficConformance;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexFact;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.primitives.registration.RegistrationAction;
import org.starl.primitives.registration.RegistrationFact;
import org.starl.random.Rng;
import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.spec.SpecReport.Violation;
import org.starl.spec.automaton.Sets;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;

/** Runs of cars after Figure 4 are runs of {@code Traffic_decls}; those of cars with a bug are not. */
class TrafficConformanceTest {

  private static final int CARS = 4;
  private static final String THEORY = "Traffic_decls";
  private static final RobotId BOT0 = new RobotId("bot0");
  private static final Instance REGISTRATION = Instance.of(RegistrationFact.PRIMITIVE, "crossing");
  private static final RecordShape<RegistrationAction.do_register> DO_REGISTER =
      Shapes.of(
              RegistrationAction.do_register.class,
              Shapes.part("i", Shapes.PROCESS, RegistrationAction.do_register::i),
              RegistrationAction.do_register::new)
          .named("do_register");

  /** How a car asks for its zones, and gives them back. */
  private record Manners(
      UnaryOperator<List<String>> asked, BiConsumer<MutexPrim, List<String>> release) {

    static final Manners GOOD = new Manners(zones -> zones, MutexPrim::release);

    /** The mutex, called in this manner. */
    MutexPrim with(MutexPrim mutex) {
      return (MutexPrim)
          Proxy.newProxyInstance(
              MutexPrim.class.getClassLoader(),
              new Class<?>[] {MutexPrim.class},
              (proxy, method, arguments) -> call(mutex, method, arguments));
    }

    private Object call(MutexPrim mutex, Method method, Object[] arguments)
        throws ReflectiveOperationException {
      switch (method.getName()) {
        case "do_mutex" ->
            mutex.do_mutex(asked.apply(zones(arguments[0])), (Participants) arguments[1]);
        case "release" -> release.accept(mutex, zones(arguments[0]));
        default -> {
          return method.invoke(mutex, arguments);
        }
      }
      return null;
    }

    private static List<String> zones(Object argument) {
      List<String> zones = new ArrayList<>();
      if (argument instanceof String[] names) {
        zones.addAll(List.of(names));
      } else {
        ((Iterable<?>) argument).forEach(zone -> zones.add((String) zone));
      }
      return zones;
    }
  }

  private static SpecReport run(Manners manners, long seed) {
    SimSettings settings = SimSettings.builder().set("duration", "300s").build();
    List<Car> cars = Car.drawn(settings.robotName(), CARS, new Rng(seed).fork("cars"));
    Traffic traffic = new Traffic(settings.robotRadiusMm(), cars);
    Simulation.Builder simulation =
        new IntersectionPlan(Floor.kerbs(), settings, CarProgram.PAPER)
            .simulation(
                new IntersectionSpec(
                    IntersectionPlan.deltaNs(settings), CARS, 0, IntersectionSpec.STOPPING_NS))
            .seed(seed)
            .director(traffic)
            .observer(traffic);
    for (Car car : cars) {
      simulation.robot(
          new RobotSpec(
              car.id(),
              car.start(),
              false,
              gvh ->
                  new IntersectionApp(
                      gvh,
                      IntersectionFactory.XID,
                      car.trip(),
                      gvh.id.participants(),
                      manners::with)));
    }
    return simulation.build().run().spec();
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void aRunIsOneOfTheTheory(long seed) {
    SpecReport report = run(Manners.GOOD, seed);
    assertThat(report.violations()).isEmpty();
    assertThat(taken(report))
        .contains("dt", "arrive", "do_register", "decide", "learn", "do_mutex", "od_mutex")
        .contains("advance", "release", "unregister");
  }

  @Test
  void aCarThatAsksForAZoneBesideItsWayIsFound() {
    Manners greedy =
        new Manners(
            zones -> Stream.concat(zones.stream(), Stream.of("Z")).toList(),
            (mutex, zones) ->
                mutex.release(mutex.held().size() > 2 ? zones : new ArrayList<>(mutex.held())));
    assertThat(run(greedy, 1).violations()).extracting(Violation::lemma).contains(THEORY);
  }

  @Test
  void aCarThatKeepsItsFirstZoneToTheEndIsFoundByTheReplayAlone() {
    Manners keeping =
        new Manners(
            zones -> zones,
            (mutex, zones) -> {
              boolean isLast = zones.stream().anyMatch(zone -> zone.endsWith("1"));
              if (isLast) {
                mutex.release(mutex.held());
              }
            });
    assertThat(run(keeping, 1).violations())
        .isNotEmpty()
        .extracting(Violation::lemma)
        .containsOnly(THEORY);
  }

  /** Without the car's registration. */
  private static Action grant() {
    return Action.of(
        2,
        BOT0,
        MutexFact.source("crossing"),
        MutexFact.SHAPE,
        new MutexFact.OdMutex(ProcessId.first(BOT0, 1), 1, Sections.copyOf(List.of("A"))));
  }

  /** The report of a run that has this, and then a grant. */
  private static SpecReport with(Fault fault) {
    Monitors monitors = new Monitors(List.of(new TrafficConformance("crossing")));
    monitors.observe(fault);
    monitors.observe(grant());
    monitors.finish(3);
    return monitors.report();
  }

  @Test
  void aRobotThatHasNotRegisteredMayRestart() {
    for (String fault : List.of(Fault.CRASH, Fault.RESTART)) {
      SpecReport report = with(new Fault(1, BOT0, fault, ""));
      assertThat(report.inPart()).isEmpty();
      assertThat(report.violations())
          .singleElement()
          .satisfies(each -> assertThat(each.detail()).contains("loc(bot0) = away"));
    }
  }

  @Test
  void aRoadsideUnitThatRestartsGivesItsIdUp() {
    SpecReport report = onOpenRoad("crash(roadside0,at=1s,restart=2s)");
    assertThat(report.inPart()).doesNotContainKey(THEORY);
    assertThat(taken(report)).contains("give_up");
  }

  @Test
  void aCarThatCrashedIsTakenOffTheRoad() {
    SpecReport report =
        onOpenRoad(
            "crash(any,at=25s); crash(any,at=30s); crash(any,at=40s); crash(any,at=50s);"
                + " crash(any,at=60s)",
            "180s");
    assertThat(report.inPart()).doesNotContainKey(THEORY);
    assertThat(taken(report)).contains("give_up", "towed", "stands_in");
  }

  /** The others give it up, and ask again and again until it says that it is in no zone. */
  @Test
  void aCarThatWaitsMayCrashAndRestart() {
    SpecReport report = drawn("crash(bot1,at=25s,restart=25s)");
    assertThat(report.inPart()).doesNotContainKey(THEORY);
    assertThat(taken(report)).contains("withdraw", "give_up", "unregister");
  }

  /** It goes on as another process, from where its body is. */
  @Test
  void aCarAmongTheZonesMayCrashAndRestart() {
    SpecReport report = drawn("crash(bot2,at=10s,restart=5s)");
    assertThat(report.inPart()).doesNotContainKey(THEORY);
    assertThat(taken(report)).contains("give_up", "restart", "stands_in", "skip");
  }

  /** The first car is granted A and A1; its program begins anew; then the other one is granted A. */
  private static SpecReport grantedAfterARestart(Optional<List<String>> standsIn) {
    ProcessId i = ProcessId.first(BOT0, 1);
    ProcessId j = ProcessId.first(new RobotId("bot1"), 1);
    List<TraceEvent> events = new ArrayList<>(bothListed(i, j));
    SortedSet<String> zones = Sets.of(List.of("A", "A1"));
    SortedSet<ProcessId> first = Sets.of(List.of(i));
    events.add(mutex(new MutexFact.DoMutex(i, 1, 1, zones, Sets.of(List.of(j)))));
    events.add(mutex(new MutexFact.OdMutex(i, 1, zones)));
    events.add(new Fault(4, BOT0, Fault.CRASH, ""));
    events.add(new Fault(5, BOT0, Fault.RESTART, ""));
    standsIn.ifPresent(
        each -> events.add(mutex(new MutexFact.StandsIn(ProcessId.first(BOT0, 2), Sets.of(each)))));
    SortedSet<String> a = Sets.of(List.of("A"));
    events.add(
        Action.of(
            6,
            j.robot(),
            MutexFact.source("crossing"),
            MutexFact.SHAPE,
            new MutexFact.DoMutex(j, 1, 2, a, first)));
    events.add(
        Action.of(
            6,
            j.robot(),
            MutexFact.source("crossing"),
            MutexFact.SHAPE,
            new MutexFact.OdMutex(j, 1, a)));
    return observed(events);
  }

  @Test
  void whatARestartedCarHeldIsKeptUntilItSaysWhereItIs() {
    for (Optional<List<String>> standsIn :
        List.of(Optional.<List<String>>empty(), Optional.of(List.of("A")))) {
      SpecReport report = grantedAfterARestart(standsIn);
      assertThat(report.inPart()).isEmpty();
      assertThat(report.violations())
          .singleElement()
          .satisfies(each -> assertThat(each.detail()).contains("od_mutex(bot1, [A])"));
    }
    assertThat(grantedAfterARestart(Optional.of(List.of())).violations()).isEmpty();
  }

  @Test
  void nothingIsCheckedInRealTime() {
    SpecReport report = with(Fault.realTime(0));
    assertThat(report.violations()).isEmpty();
    assertThat(report.inapplicable(THEORY)).contains("measured");
  }

  /** On an open road, cars ask under other ids where a list that they did not see may have had the first. */
  @Test
  void anIdThatNoListHasIsGivenUp() {
    assertThat(onOpenRoad("").inPart()).doesNotContainKey(THEORY);
  }

  private static Action registered(ProcessId i) {
    return Action.of(
        1, i.robot(), REGISTRATION, DO_REGISTER, new RegistrationAction.do_register(i));
  }

  private static Action mutex(MutexFact fact) {
    return Action.of(3, BOT0, MutexFact.source("crossing"), MutexFact.SHAPE, fact);
  }

  /** Two cars are listed, and bot0 asks for its zones; then bot1 gives it up, or does not. */
  private static SpecReport granted(boolean isGivenUp) {
    ProcessId i = ProcessId.first(BOT0, 1);
    ProcessId j = ProcessId.first(new RobotId("bot1"), 1);
    SortedSet<ProcessId> others = Sets.of(List.of(j));
    SortedSet<String> zones = Sets.of(List.of("A", "A1"));
    Confinement word = new Confinement(i, zones, others);
    List<TraceEvent> events = new ArrayList<>(bothListed(i, j));
    events.add(mutex(new MutexFact.DoMutex(i, 1, 1, zones, others)));
    if (isGivenUp) {
      events.add(Action.of(3, j.robot(), REGISTRATION, Confinement.SHAPE, word));
    }
    events.add(mutex(new MutexFact.OdMutex(i, 1, zones)));
    return observed(events);
  }

  private static List<TraceEvent> bothListed(ProcessId i, ProcessId j) {
    View both = View.closed(List.of(i, j));
    return List.of(
        Action.of(
            0,
            i.robot(),
            Instance.APP,
            Way.SHAPE,
            new Way("A1", Optional.empty(), List.of("A", "A1"))),
        Action.of(
            0, j.robot(), Instance.APP, Way.SHAPE, new Way("A", Optional.empty(), List.of("A"))),
        registered(i),
        registered(j),
        new Variable(2, i.robot(), REGISTRATION, RegistrationFact.VIEW, both),
        new Variable(2, j.robot(), REGISTRATION, RegistrationFact.VIEW, both));
  }

  private static SpecReport observed(List<TraceEvent> events) {
    Monitors monitors = new Monitors(List.of(new TrafficConformance("crossing")));
    events.forEach(monitors::observe);
    monitors.finish(7);
    return monitors.report();
  }

  /** Those who vouch for it may have consented to its request before. */
  @Test
  void nothingIsCheckedAfterACarThatOthersGaveUpGoesOn() {
    assertThat(granted(false).violations()).isEmpty();
    assertThat(granted(false).inPart()).isEmpty();
    assertThat(granted(true).violations()).isEmpty();
    assertThat(granted(true).inPart().get(THEORY))
        .startsWith("bot0 is granted zones after others gave it up");
  }

  private static SpecReport drawn(String faults) {
    return IntersectionTest.run(
            IntersectionTest.request(12, 6, Map.of("car", "paper")), Map.of("faults", faults))
        .spec();
  }

  private static List<String> taken(SpecReport report) {
    return report.reached().keySet().stream()
        .filter(each -> each.theory().equals(THEORY) && each.conjunct().isEmpty())
        .map(each -> each.action().getSimpleName())
        .toList();
  }

  private static SpecReport onOpenRoad(String faults) {
    return onOpenRoad(faults, "90s");
  }

  private static SpecReport onOpenRoad(String faults, String duration) {
    Map<String, String> open = Map.of("scenario", "open", "car", "paper", "arrivals", "12/min");
    Map<String, String> settings = Map.of("duration", duration, "faults", faults);
    return IntersectionTest.run(IntersectionTest.request(3, 0, open), settings).spec();
  }
}
