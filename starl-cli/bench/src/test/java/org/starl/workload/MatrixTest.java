package org.starl.workload;

import static java.util.Map.entry;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.apps.Demo;
import org.starl.apps.Plan;
import org.starl.primitives.agreement.AgreementSpec;
import org.starl.primitives.barrier.BarrierSpec;
import org.starl.primitives.election.ElectionSpec;
import org.starl.primitives.geocast.GeocastSpec;
import org.starl.primitives.ledger.LedgerSpec;
import org.starl.primitives.motion.MotionSpec;
import org.starl.primitives.mutex.ModesConformance;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.mutex.PipelineConformance;
import org.starl.primitives.paths.TubesSpec;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.fault.FaultGrammar;
import org.starl.sim.fault.FaultGrammar.Kind;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;

/** Three robots with each primitive, under the specifications of all, with each kind of fault. */
class MatrixTest {

  private static final String UNTIL = ",until=3s)";

  /** By the name of the workload that has the specification already. */
  private static final SortedMap<String, Function<SimSettings, Monitor>> SPECS =
      new TreeMap<>(
          Map.<String, Function<SimSettings, Monitor>>ofEntries(
              entry("agreement", settings -> new AgreementSpec()),
              entry("barrier", settings -> new BarrierSpec()),
              entry("election", settings -> new ElectionSpec()),
              entry("geocast", settings -> new GeocastSpec()),
              entry("ledger", settings -> new LedgerSpec()),
              entry("motion", settings -> new MotionSpec(settings.motionParameters(0))),
              entry("mutex", settings -> new MutexSpec()),
              entry("mutex of modes", settings -> new ModesConformance()),
              entry("mutex of sequences", settings -> new PipelineConformance()),
              entry("paths", settings -> new TubesSpec()),
              entry("registration", settings -> new RegistrationSpec())));

  /** Workloads that have another primitive's specification, too. */
  private static final Set<String> OTHERS = Set.of("barrier registration", "mutex registration");

  /** By their kinds. With a star: the run has a key, which seals datagrams. */
  private static final SortedMap<String, String> FAULTS =
      new TreeMap<>(
          Map.ofEntries(
              entry("none", ""),
              entry("loss", "loss(0.3" + UNTIL),
              entry("burst", "burst(1s,200ms,0.9" + UNTIL),
              entry("delay", "delay(uniform(10ms,200ms)" + UNTIL),
              entry("duplicate", "duplicate(0.3,50ms" + UNTIL),
              entry("reorder", "reorder(0.3,100ms" + UNTIL),
              entry("partition", "partition(bot0|bot1+bot2" + UNTIL),
              entry("datagram", "datagram(bot0>bot1,2,lost)"),
              entry("range", "range(1m" + UNTIL),
              entry("sight", "sight(until=3s)"),
              entry("crash", "crash(bot1,at=2s,restart=500ms,lose=unsynced)"),
              entry("disk", "disk(bot1,20ms" + UNTIL),
              entry("forget", "forget(bot1,50ms,1s" + UNTIL),
              entry("compute", "compute(bot1,2ms" + UNTIL),
              entry("drift", "drift(bot1,200ppm" + UNTIL),
              entry("skew", "skew(bot1,10ms" + UNTIL),
              entry("noise", "noise(bot1,20mm,1deg" + UNTIL),
              entry("dropout", "dropout(bot1,at=2s,for=1s)"),
              entry("slow", "slow(bot1,0.5" + UNTIL),
              entry("stuck", "stuck(bot1" + UNTIL),
              entry("jump", "jump(bot1,300mm" + UNTIL),
              entry("ram", "ram(bot1" + UNTIL),
              entry("block", "block(bot1" + UNTIL),
              entry("forge", "forge(bot1,50ms" + UNTIL),
              entry("replay", "replay(bot1,50ms" + UNTIL),
              entry("flood", "flood(bot1,50ms" + UNTIL),
              entry("forge*", "forge(bot1,50ms" + UNTIL),
              entry("replay*", "replay(bot1,50ms" + UNTIL),
              entry("flood*", "flood(bot1,50ms" + UNTIL)));

  /**
   * Faults that some workloads need not tolerate: then only their own lemmas may be violated, and the
   * run must end with a verdict. A jump shifts fixes and does not report it; robots that drive rely on
   * the reported error. A forged datagram is believed if there is no key.
   */
  private static final Map<String, Set<String>> NOT_TOLERATED =
      Map.of(
          "jump", Set.of("geocast", "motion", "paths"),
          "forge", names().collect(Collectors.toSet()));

  /** It is about robots that missed a message. In these workloads, only a fault makes a robot miss one. */
  static final Set<String> ONLY_WITH_FAULTS = Set.of("election.Behind", "registration.Completes");

  private static Plan plan(String name, String fault, long seed) {
    Map<String, String> set = new TreeMap<>(Map.of("busy", "5s", "positionNoise", "5mm"));
    if (!fault.equals("none")) {
      set.put("faults", FAULTS.get(fault));
      set.put("sealed", Boolean.toString(fault.endsWith("*")));
    }
    Plan plan = Runs.plan(name, seed, OptionalInt.of(3), set);
    SimSettings settings = plan.simulation().build().plan().settings();
    SPECS.forEach((primitive, spec) -> {
      if (!primitive.equals(name) && !OTHERS.contains(name + " " + primitive)) {
        plan.simulation().monitor(() -> spec.apply(settings));
      }
    });
    return plan;
  }

  static Stream<String> names() {
    return PrimitiveWorkloads.ALL.stream().map(Demo::name);
  }

  private static Monitors monitors(Plan plan) {
    return Monitors.of(plan.simulation().build().plan().monitors());
  }

  private static void check(String name, String fault, long seed) {
    SpecReport spec = plan(name, fault, seed).simulation().build().run().spec();
    String what = "starl run " + name + " --seed " + seed + " --set faults=" + FAULTS.get(fault);
    boolean isOutside = NOT_TOLERATED.getOrDefault(fault, Set.of()).contains(name);
    List<String> own =
        isOutside || fault.equals("none")
            ? monitors(Runs.plan(name, seed, Map.of())).lemmas()
            : List.of();
    assertThat(spec.violations())
        .as(what)
        .allMatch(violation -> isOutside && own.contains(violation.lemma()));
    if (fault.equals("none")) {
      List<String> never = new ArrayList<>(spec.neverChecked());
      never.removeAll(ONLY_WITH_FAULTS);
      assertThat(never).as(what).doesNotContainAnyElementsOf(own);
    }
  }

  /** A quarter of the faults for each primitive, and each fault for two primitives or three. */
  @ParameterizedTest
  @MethodSource("names")
  void noSpecificationIsDisturbedByAnotherPrimitive(String name) {
    check(name, "none", 5);
    int shift = names().toList().indexOf(name);
    List<String> faults = List.copyOf(FAULTS.keySet());
    for (int i = shift % 4; i < faults.size(); i += 4) {
      check(name, faults.get(i), 5);
    }
  }

  @Tag("long")
  @ParameterizedTest
  @MethodSource("names")
  void norUnderAnyFaultWithOtherSeeds(String name) {
    for (long seed = 1; seed <= 5; seed++) {
      for (String fault : FAULTS.keySet()) {
        check(name, fault, seed);
      }
    }
  }

  @Test
  void everyKindOfFaultIsInTheMatrix() {
    assertThat(FAULTS.keySet())
        .filteredOn(fault -> !fault.equals("none") && !fault.endsWith("*"))
        .containsExactlyInAnyOrderElementsOf(
            FaultGrammar.kinds().stream().map(Kind::name).toList());
  }

  @Test
  void everyMonitorOfEveryPrimitiveIsInEachRun() {
    List<String> monitors =
        new ClassFileImporter()
                .withImportOption(new ImportOption.DoNotIncludeTests())
                .withImportOption(location -> !location.contains("/run/test-classes/"))
                .importPackages("org.starl.primitives")
                .stream()
                .filter(type -> type.isAssignableTo(Monitor.class))
                .filter(type -> !type.getModifiers().contains(JavaModifier.ABSTRACT))
                .map(JavaClass::getName)
                .toList();
    assertThat(monitors).hasSizeGreaterThan(15);
    names()
        .forEach(name ->
            assertThat(monitors(plan(name, "none", 5)).monitors())
                .as(name)
                .extracting(monitor -> monitor.getClass().getName())
                .containsAll(monitors));
  }
}
