package org.starl.workload;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.apps.Demo;
import org.starl.apps.Plan;
import org.starl.primitives.agreement.AgreementSpec;
import org.starl.primitives.barrier.BarrierSpec;
import org.starl.primitives.election.ElectionSpec;
import org.starl.primitives.geocast.GeocastSpec;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.paths.TubesSpec;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.sim.SimResult;
import org.starl.sim.fault.FaultGrammar;
import org.starl.sim.fault.FaultGrammar.Kind;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;

/** Three robots with each primitive, under the specifications of all, with each kind of fault. */
class MatrixTest {

  private static final String UNTIL = ",until=3s)";

  /** By the name of the workload that has the specification already. */
  private static final Map<String, Supplier<Monitor>> SPECS =
      new TreeMap<>(
          Map.of(
              "agreement", AgreementSpec::new,
              "barrier", BarrierSpec::new,
              "election", ElectionSpec::new,
              "geocast", GeocastSpec::new,
              "mutex", MutexSpec::new,
              "paths", TubesSpec::new,
              "registration", RegistrationSpec::new));

  /** Workloads that register their robots. */
  private static final Set<String> REGISTERED = Set.of("barrier", "mutex");

  private static final Map<String, String> NETWORK =
      Map.of(
          "loss", "loss(0.3" + UNTIL,
          "burst", "burst(1s,200ms,0.9" + UNTIL,
          "delay", "delay(uniform(10ms,200ms)" + UNTIL,
          "duplicate", "duplicate(0.3,50ms" + UNTIL,
          "reorder", "reorder(0.3,100ms" + UNTIL,
          "partition", "partition(bot0|bot1+bot2" + UNTIL,
          "datagram", "datagram(bot0>bot1,2,lost)");

  private static final Map<String, String> CRASHES =
      Map.of(
          "crash", "crash(bot1,at=2s,restart=500ms,lose=unsynced)",
          "disk", "disk(bot1,20ms" + UNTIL,
          "forget", "forget(bot1,50ms,1s" + UNTIL);

  private static final Map<String, String> TIME =
      Map.of(
          "compute", "compute(bot1,2ms" + UNTIL,
          "drift", "drift(bot1,200ppm" + UNTIL,
          "skew", "skew(bot1,10ms" + UNTIL);

  private static final Map<String, String> BODY =
      Map.of(
          "noise", "noise(bot1,20mm,1deg" + UNTIL,
          "dropout", "dropout(bot1,at=2s,for=1s)",
          "slow", "slow(bot1,0.5" + UNTIL,
          "stuck", "stuck(bot1" + UNTIL,
          "drift", "drift(bot1,200ppm" + UNTIL);

  /** Outside every envelope, or need a key, or a radio of limited range. */
  private static final Set<String> ELSEWHERE =
      Set.of("range", "sight", "jump", "ram", "block", "forge", "replay", "flood");

  private static List<String> faults(String name) {
    List<String> faults = new ArrayList<>(NETWORK.values());
    switch (name) {
      case "geocast", "motion" -> faults.addAll(BODY.values());
      case "paths" -> {
        faults.addAll(BODY.values());
        faults.addAll(CRASHES.values());
      }
      default -> {
        faults.addAll(CRASHES.values());
        faults.addAll(TIME.values());
      }
    }
    faults.add("none");
    return faults;
  }

  static Stream<String> names() {
    return PrimitiveWorkloads.ALL.stream().map(Demo::name);
  }

  private static SimResult run(String name, String fault) {
    Map<String, String> set = new TreeMap<>(Map.of("busy", "5s", "positionNoise", "5mm"));
    if (!fault.equals("none")) {
      set.put("faults", fault);
    }
    Plan plan = Runs.plan(name, 5, OptionalInt.of(3), set);
    SPECS.forEach((primitive, spec) -> {
      boolean hasIt = primitive.equals(name) || isRegistrationOf(primitive, name);
      if (!hasIt) {
        plan.simulation().monitor(spec);
      }
    });
    return plan.simulation().build().run();
  }

  private static boolean isRegistrationOf(String primitive, String name) {
    return primitive.equals("registration") && REGISTERED.contains(name);
  }

  private static List<String> own(String name) {
    return Monitors.of(Runs.plan(name, 5, Map.of()).simulation().build().plan().monitors())
        .lemmas();
  }

  @ParameterizedTest
  @MethodSource("names")
  void noSpecificationIsDisturbedByAnotherPrimitive(String name) {
    for (String fault : faults(name)) {
      SimResult result = run(name, fault);
      String what = "starl run " + name + " --seed 5 --set faults=" + fault;
      assertThat(result.spec().holds()).as("%s: %s", what, result.spec()).isTrue();
      if (fault.equals("none")) {
        assertThat(result.spec().neverChecked()).as(what).doesNotContainAnyElementsOf(own(name));
      }
    }
  }

  @Test
  void everyKindOfFaultIsInTheMatrix() {
    Set<String> kinds = new TreeSet<>(ELSEWHERE);
    List.of(NETWORK, CRASHES, TIME, BODY).forEach(faults -> kinds.addAll(faults.keySet()));
    assertThat(kinds)
        .containsExactlyInAnyOrderElementsOf(
            FaultGrammar.kinds().stream().map(Kind::name).toList());
  }
}
