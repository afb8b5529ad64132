package org.starl.spec.automaton;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Random;
import java.util.TreeMap;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.jspecify.annotations.Nullable;
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

  /** Values are compared with those of a map of the library; all versions stay as they were. */
  @Property(tries = 200)
  void anyHistoryGivesTheFunctionOfItsLatestChanges(@ForAll long seed) {
    Random random = new Random(seed);
    int arguments = 1 + random.nextInt(300);
    boolean isInOrder = random.nextBoolean();
    NavigableMap<Integer, Integer> model = new TreeMap<>();
    Fun<Integer, Integer> fun = Fun.always(0);
    List<Fun<Integer, Integer>> versions = new ArrayList<>();
    List<String> texts = new ArrayList<>();
    for (int change = 0; change < 600; change++) {
      int argument = isInOrder && change < arguments ? change : random.nextInt(arguments);
      int value = change < 300 || random.nextInt(3) == 0 ? random.nextInt(3) : 0;
      fun = fun.with(argument, value);
      model.put(argument, value);
      model.values().removeIf(each -> each == 0);
      if (change % 50 == 0) {
        versions.add(fun);
        texts.add(text(model));
        isAs(model, fun);
      }
    }
    isAs(model, fun);
    assertThat(versions).extracting(Object::toString).isEqualTo(texts);
  }

  private static void isAs(NavigableMap<Integer, Integer> model, Fun<Integer, Integer> fun) {
    assertThat(fun.size()).isEqualTo(model.size());
    assertThat(fun.arguments()).isEqualTo(model.keySet()).containsExactlyElementsOf(model.keySet());
    assertThat(fun.hashCode()).isEqualTo(model.hashCode());
    assertThat(fun).hasToString(text(model));
    Fun<Integer, Integer> backwards = Fun.always(0);
    for (int argument : model.descendingKeySet()) {
      backwards = backwards.with(argument, model.get(argument));
    }
    assertThat(fun).isEqualTo(backwards);
  }

  private static String text(Map<Integer, Integer> model) {
    return model.toString().replace('{', '(').replace('}', ')').replace("=", ": ");
  }

  /** So each change takes logarithmic time, in whatever order they come. */
  @Property(tries = 100)
  void treesStayBalanced(@ForAll long seed) {
    Random random = new Random(seed);
    Tree<Integer, Boolean> tree = null;
    int order = random.nextInt(3);
    for (int n = 0; n < 500; n++) {
      int key = order == 0 ? n : order == 1 ? -n : random.nextInt(1000);
      tree = Tree.put(tree, key, true);
      isBalanced(tree);
    }
    for (int n = 0; n < 500; n++) {
      int key = order == 0 ? n : order == 1 ? n - 500 : random.nextInt(1000);
      tree = Tree.remove(tree, key);
      isBalanced(tree);
    }
  }

  private static void isBalanced(@Nullable Tree<Integer, Boolean> tree) {
    if (tree != null) {
      int left = Tree.size(tree.left) + 1;
      int right = Tree.size(tree.right) + 1;
      assertThat(Math.max(left, right)).isLessThanOrEqualTo(3 * Math.min(left, right));
      isBalanced(tree.left);
      isBalanced(tree.right);
    }
  }

  @Test
  void aChangeToTheSameValueGivesTheSameFunction() {
    Fun<String, Integer> fun = Fun.<String, Integer>always(0).with("a", 1);
    assertThat(fun.with("a", 1)).isSameAs(fun);
    assertThat(fun.with("b", 0)).isSameAs(fun);
    assertThatThrownBy(() -> fun.arguments().remove("a"))
        .isInstanceOf(UnsupportedOperationException.class);
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
