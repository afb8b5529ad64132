package org.starl.lang.read;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToIntFunction;
import java.util.stream.Collectors;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Row;
import org.starl.lang.eval.Sizes;

/** One step of a program's automaton is what its statements do, one after the other. */
class ProgramsPropertyTest {

  private static final List<String> VARIABLES = List.of("x", "y", "z");
  private static final int MOST = 1000;

  /** A value: its text, and what it is. */
  record Value(String text, ToIntFunction<Map<String, Integer>> of) {}

  record Assign(String variable, Value value) {}

  /** The guard is {@code x < less}. */
  record Branch(int less, List<Assign> statements) {}

  @Provide
  Arbitrary<Value> values() {
    Arbitrary<String> name = Arbitraries.of(VARIABLES);
    Arbitrary<Value> sum =
        Combinators.combine(name, Arbitraries.integers().between(0, 3))
            .as((a, n) -> new Value(a + " + " + n, state -> state.get(a) + n));
    Arbitrary<Value> larger =
        Combinators.combine(name, name)
            .as((a, b) ->
                new Value(
                    "if %s < %s then %s else %s".formatted(a, b, b, a),
                    state -> Math.max(state.get(a), state.get(b))));
    return Arbitraries.oneOf(sum, larger);
  }

  @Provide
  Arbitrary<List<Branch>> branches() {
    Arbitrary<Assign> assign =
        Combinators.combine(Arbitraries.of(VARIABLES), values()).as(Assign::new);
    Arbitrary<Branch> branch =
        Combinators.combine(
                Arbitraries.integers().between(0, 3), assign.list().ofMinSize(1).ofMaxSize(5))
            .as(Branch::new);
    return branch.list().ofMinSize(1).ofMaxSize(3);
  }

  @Property(tries = 100)
  void stepIsTheFirstBranchWhoseGuardHoldsWithItsStatementsInOrder(
      @ForAll("branches") List<Branch> branches) throws SourceErrors {
    Map<String, Integer> state = new LinkedHashMap<>(Map.of("x", 1, "y", 2, "z", 5));
    List<Map<String, Integer>> expected = new ArrayList<>();
    branches.stream()
        .filter(branch -> state.get("x") < branch.less())
        .findFirst()
        .ifPresent(branch -> {
          Map<String, Integer> after = new LinkedHashMap<>(state);
          branch
              .statements()
              .forEach(s -> after.put(s.variable(), s.value().of().applyAsInt(after)));
          expected.add(after);
        });
    assertThat(steps(text(branches))).isEqualTo(expected);
  }

  private static String text(List<Branch> branches) {
    return "program Sums state x: nat := 1 y: nat := 2 z: nat := 5 location here\n"
        + branches.stream()
            .map(branch ->
                branch.statements().stream()
                    .map(s -> s.variable() + " := " + s.value().text())
                    .collect(
                        Collectors.joining(
                            "; ", "when x < " + branch.less() + " do ", "; goto here\n")))
            .collect(Collectors.joining());
  }

  /** The variables after each step that one process can take. */
  private static List<Map<String, Integer>> steps(String program) throws SourceErrors {
    Sizes sizes = new Sizes(new LinkedHashMap<>(Map.of("PIDS", 1)), MOST, 0);
    Machine machine = new Machine(new SourceReader().read("sums.starl", program).getFirst(), sizes);
    List<Map<String, Integer>> all = new ArrayList<>();
    machine.steps(
        machine.starts(Map.of()).states().getFirst(),
        new Machine.Steps() {
          @Override
          public void step(int action, Object[] arguments, Row after) {
            Map<String, Integer> values = new LinkedHashMap<>();
            for (int i = 0; i < machine.parts().size(); i++) {
              String name = machine.parts().get(i).name();
              if (VARIABLES.contains(name)) {
                String text = machine.parts().get(i).domain().text(after.get(i));
                values.put(name, Integer.parseInt(text.replaceAll("\\D*0 -> |]", "")));
              }
            }
            all.add(values);
          }
        });
    return all;
  }
}
