package org.starl.spec.automaton;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;

class FunTest {

  @Property(tries = 200)
  void valuesAreThoseOfTheLatestChanges(
      @ForAll @Size(max = 40) List<@IntRange(min = 0, max = 99) Integer> changes) {
    Map<Integer, Integer> model = new TreeMap<>();
    Fun<Integer, Integer> fun = Fun.always(0);
    for (int change : changes) {
      int argument = change / 10;
      int value = change % 10;
      Fun<Integer, Integer> before = fun;
      int was = before.at(argument);
      fun = fun.with(argument, value);
      assertThat(before.at(argument)).isEqualTo(was);
      model.put(argument, value);
    }
    model.values().removeIf(value -> value == 0);
    Map<Integer, Integer> seen = new TreeMap<>();
    List<Integer> order = new ArrayList<>();
    fun.forEach((argument, value) -> {
      seen.put(argument, value);
      order.add(argument);
    });
    assertThat(seen).isEqualTo(model);
    assertThat(order).isSorted().hasSize(fun.size());
    for (int argument = -1; argument <= 10; argument++) {
      assertThat(fun.at(argument)).isEqualTo(model.getOrDefault(argument, 0));
    }
    assertThat(fun.isConstant()).isEqualTo(model.isEmpty());
    assertThat(fun.allMatch((argument, value) -> value < 5))
        .isEqualTo(model.values().stream().allMatch(value -> value < 5));
  }

  @Test
  void equalFunctionsAreEqualWhateverTheirHistory() {
    Fun<String, Integer> there = Fun.<String, Integer>always(0).with("a", 1).with("b", 2);
    Fun<String, Integer> here =
        Fun.<String, Integer>always(0).with("b", 3).with("c", 1).with("a", 1).with("b", 2);
    assertThat(here).isNotEqualTo(there);
    assertThat(here.with("c", 0)).isEqualTo(there).hasSameHashCodeAs(there);
    assertThat(here).hasToString("(a: 1, b: 2, c: 1)");
    assertThat(Fun.always(1)).isNotEqualTo(Fun.always(0));
  }
}
