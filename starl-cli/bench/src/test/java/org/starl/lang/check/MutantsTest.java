package org.starl.lang.check;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.lang.check.Mutants.Mutant;
import org.starl.lang.eval.EvalError;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Row;
import org.starl.lang.eval.Sizes;
import org.starl.lang.prove.Prover;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;

/** The automata in {@code pvs/starl} with one thing made wrong, and what sees it: docs/mutants.md. */
@Tag("nightly")
class MutantsTest {

  /** So many states of an automaton are visited, besides its start states. */
  private static final int MOST = 6000;

  /** So many of one that only adds steps. */
  private static final int MOST_TO_COMPARE = 50_000;

  /** So many runs are replayed on the mutants of an automaton; fewer if all are seen. */
  private static final long RUNS = 12;

  /** Few runs of a ledger reopen a task that is claimed again later. */
  private static final long LEDGER_RUNS = 26;

  private static final long Z3_LIMIT = 10_000_000;

  /** What sees a mutant, the strongest first. */
  private enum Seen {
    /** Its exhaustive check: an invariant is false, or an operation has no value. */
    CHECK,
    /** It forbids a step of the automaton, or gives it another result: a replayed run has this step. */
    LOSES,
    /** It reaches further states, or too many to tell, and no invariant is found false. */
    REACHES,
    /** It allows further steps between the same states: no invariant can see it. */
    ADDS,
    /** At these sizes it is the same automaton. */
    SAME
  }

  @TempDir private static Path classes;

  /** Sizes, with values of value parameters. */
  private record Instance(Sizes sizes, Map<String, Object> given) {}

  @ParameterizedTest
  @ValueSource(
      strings = {
        "Mutex_decls",
        "Mutex_group_decls",
        "Pipeline_decls",
        "Modes_decls",
        "Registration_decls",
        "SetAgreement_decls",
        "Election_decls",
        "Barrier_decls",
        "Ledger_decls",
        "Geocast_decls",
        "MotionControl_decls",
        "Traffic_decls"
      })
  void tableSaysWhatSeesEachMutant(String name) throws IOException, SourceErrors {
    Path file = Path.of("../../pvs/starl").resolve(name + ".starl").toAbsolutePath();
    Automaton automaton = new SourceReader().read(file).getLast();
    Map<Seen, List<String>> seen = new EnumMap<>(Seen.class);
    for (Seen each : Seen.values()) {
      seen.put(each, new ArrayList<>());
    }
    List<Instance> instances = instances(automaton);
    List<Mutant> mutants = Mutants.of(automaton);
    Set<String> loses = new HashSet<>();
    Set<String> adds = new HashSet<>();
    for (Instance instance : instances) {
      compare(automaton, mutants, instance, loses, adds);
    }
    for (Mutant mutant : mutants) {
      boolean isWrong =
          adds.contains(mutant.toString())
              && instances.stream().anyMatch(each -> isFound(mutant, each));
      Seen by = isWrong ? Seen.CHECK : Seen.SAME;
      if (!isWrong && loses.contains(mutant.toString())) {
        by = Seen.LOSES;
      } else if (!isWrong && adds.contains(mutant.toString())) {
        by =
            instances.stream().allMatch(each -> staysWithin(automaton, mutant, each))
                ? Seen.ADDS
                : Seen.REACHES;
      }
      seen.get(by).add(mutant.toString());
    }
    List<String> byZ3 =
        mutants.parallelStream()
            .filter(each -> !isProved(automaton, each))
            .map(Mutant::toString)
            .toList();
    List<String> byRuns =
        seenInRuns(
            automaton, mutants.stream().filter(each -> loses.contains(each.toString())).toList());
    write(name, seen, byZ3, byRuns);
    String row =
        "| `%s` | %d | %d | %d | %d | %d | %d | %d | %s |"
            .formatted(
                name,
                mutants.size(),
                seen.get(Seen.CHECK).size(),
                seen.get(Seen.LOSES).size(),
                seen.get(Seen.REACHES).size(),
                seen.get(Seen.ADDS).size(),
                seen.get(Seen.SAME).size(),
                byZ3.size(),
                MutantReplay.hasMonitor(automaton) ? byRuns.size() : "-");
    assertThat(Files.readString(Path.of("../../docs/mutants.md"))).contains(row);
    List<String> unseen = new ArrayList<>(seen.get(Seen.LOSES));
    unseen.removeAll(byRuns);
    unseen.removeAll(PvsMutants.of(name, mutants));
    assertThat(unseen).as("lose a step, and neither a replay nor pvs/mutants tells").isEmpty();
  }

  /** Z3 takes minutes for each mutant of these, and pvs/mutants has wrong versions of its own. */
  @ParameterizedTest
  @ValueSource(strings = {"MutexProtocol_decls", "Synod_decls"})
  void tableSaysWhatReplaysSeeOfEachProtocol(String name) throws IOException, SourceErrors {
    Path file = Path.of("../../pvs/starl").resolve(name + ".starl").toAbsolutePath();
    Automaton automaton = new SourceReader().read(file).getLast();
    List<Mutant> mutants = Mutants.of(automaton);
    Set<String> loses = new HashSet<>();
    for (Instance instance : instances(automaton)) {
      compare(automaton, mutants, instance, loses, new HashSet<>());
    }
    List<Mutant> lost = mutants.stream().filter(each -> loses.contains(each.toString())).toList();
    List<String> byRuns = seenInRuns(automaton, lost);
    write(name, Map.of(Seen.LOSES, List.copyOf(loses)), List.of(), byRuns);
    assertThat(Files.readString(Path.of("../../docs/mutants.md")))
        .contains(
            "| `%s` | %d | %d | %d |".formatted(name, mutants.size(), lost.size(), byRuns.size()));
  }

  /**
   * Whether Z3 proves that the changed action can happen and keeps the invariants. The other actions
   * are as before: they keep what they kept.
   */
  private static boolean isProved(Automaton automaton, Mutant mutant) {
    Automaton changed = Mutants.with(automaton, List.of(mutant.action()));
    return new Prover(changed, Z3_LIMIT, (file, text) -> {}).prove().isProved();
  }

  /**
   * Those of {@code mutants} that a conformance monitor tells from the automaton, in runs of the
   * primitive. One that loses no step it cannot tell.
   */
  private static List<String> seenInRuns(Automaton automaton, List<Mutant> mutants)
      throws IOException {
    if (!MutantReplay.hasMonitor(automaton)) {
      return List.of();
    }
    List<MutantReplay> all = new ArrayList<>();
    for (Mutant mutant : mutants) {
      MutantReplay.of(mutant.toString(), mutant.automaton(), classes).ifPresent(all::add);
    }
    MutantReplay right = MutantReplay.of("right", automaton, classes).orElseThrow();
    List<MutantReplay> open = new ArrayList<>(all);
    long runs = automaton.name().equals("Ledger_decls") ? LEDGER_RUNS : RUNS;
    for (long seed = 1; seed <= runs && !open.isEmpty(); seed++) {
      MutantReplay.run(automaton, seed, Stream.concat(open.stream(), Stream.of(right)).toList());
      assertThat(right.isSeen()).as("the automaton itself deviates").isFalse();
      open.removeIf(MutantReplay::isSeen);
    }
    return all.stream().filter(MutantReplay::isSeen).map(MutantReplay::name).toList();
  }

  private static void write(
      String name, Map<Seen, List<String>> seen, List<String> byZ3, List<String> byRuns)
      throws IOException {
    StringBuilder text = new StringBuilder();
    seen.forEach((by, all) -> {
      text.append(by).append(' ').append(all.size()).append('\n');
      for (String each : all) {
        text.append("  ").append(each);
        text.append(byZ3.contains(each) ? "; Z3" : "").append(byRuns.contains(each) ? "; run" : "");
        text.append('\n');
      }
    });
    Files.writeString(
        Files.createDirectories(Path.of("target/mutants")).resolve(name + ".txt"), text);
  }

  private static List<Instance> instances(Automaton automaton) {
    if (automaton.name().equals("Traffic_decls")) {
      return List.of(traffic(automaton, 1, 2, 2, 1), traffic(automaton, 2, 3, 0, 0));
    }
    Map<String, Integer> opaque = new LinkedHashMap<>();
    Machine.opaqueTypes(automaton).forEach(type -> opaque.put(type, 2));
    return List.of(new Instance(new Sizes(opaque, 2, 2), Map.of()));
  }

  private static Instance traffic(Automaton automaton, int cars, int nat, int time, int bound) {
    Sizes sizes = new Sizes(Map.of("PIDS", cars, "Zones", 2, "SD", 1), nat, time);
    Machine machine = new Machine(automaton, sizes);
    Map<String, Object> given = new TreeMap<>();
    for (String each : List.of("B", "R", "G", "T")) {
      given.put(each, value(machine, automaton, bound));
    }
    return new Instance(sizes, given);
  }

  private static Object value(Machine machine, Automaton automaton, int number) {
    try {
      return machine.value(
          SourceReader.readExpression(
              automaton,
              machine.elements(),
              automaton.valueParameters().getLast().type(),
              "test",
              String.valueOf(number)));
    } catch (SourceErrors e) {
      throw new AssertionError(e);
    }
  }

  /** The steps with arguments within the bounds. */
  private static final class Collector implements Machine.Steps {

    private final Machine machine;
    final Map<Integer, Set<List<Object>>> steps = new LinkedHashMap<>();
    boolean isBroken;

    Collector(Machine machine) {
      this.machine = machine;
    }

    @Override
    public void step(int action, Object[] arguments, Row after) {
      if (machine.areWithin(action, arguments)) {
        steps
            .computeIfAbsent(action, any -> new HashSet<>())
            .add(List.of(Arrays.asList(arguments), after));
      }
    }

    @Override
    public void error(int action, Object[] arguments, EvalError error) {
      isBroken = true;
    }
  }

  /** Which mutants have other steps in the states that the automaton reaches. */
  private static void compare(
      Automaton automaton,
      List<Mutant> mutants,
      Instance instance,
      Set<String> loses,
      Set<String> adds) {
    Machine machine = new Machine(automaton, instance.sizes);
    Search search = new Search(machine, instance.sizes, instance.given, true, MOST);
    assertThat(search.run().finding()).isEmpty();
    List<Machine> changed = new ArrayList<>();
    for (Mutant mutant : mutants) {
      changed.add(new Machine(Mutants.with(automaton, List.of(mutant.action())), instance.sizes));
    }
    List<String> actions = automaton.actions().stream().map(a -> a.name()).toList();
    for (Row state : search.visited()) {
      Collector right = new Collector(machine);
      machine.steps(state, right);
      for (int i = 0; i < mutants.size(); i++) {
        String name = mutants.get(i).toString();
        if (loses.contains(name) && adds.contains(name)) {
          continue;
        }
        Collector wrong = new Collector(changed.get(i));
        changed.get(i).steps(state, wrong);
        int action = actions.indexOf(mutants.get(i).action().name());
        Set<List<Object>> before = right.steps.getOrDefault(action, Set.of());
        Set<List<Object>> after = wrong.steps.getOrDefault(0, Set.of());
        if (!after.containsAll(before)) {
          loses.add(name);
        }
        if (wrong.isBroken || !before.containsAll(after)) {
          adds.add(name);
        }
      }
    }
  }

  private static boolean isFound(Mutant mutant, Instance instance) {
    Machine machine = new Machine(mutant.automaton(), instance.sizes);
    int starts = machine.starts(instance.given).states().size();
    return new Search(machine, instance.sizes, instance.given, true, MOST + starts)
        .run()
        .finding()
        .isPresent();
  }

  private static boolean staysWithin(Automaton automaton, Mutant mutant, Instance instance) {
    Search of = search(automaton, instance);
    Search ofMutant = search(mutant.automaton(), instance);
    return of.run().isComplete()
        && ofMutant.run().isComplete()
        && new HashSet<>(of.visited()).containsAll(ofMutant.visited());
  }

  private static Search search(Automaton automaton, Instance instance) {
    Machine machine = new Machine(automaton, instance.sizes);
    return new Search(machine, instance.sizes, instance.given, true, MOST_TO_COMPARE);
  }
}
