package org.starl.spec.automaton;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.NavigableSet;
import java.util.NoSuchElementException;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Consumer;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;

class SetsTest {

  /** Every operation is compared with that of the JDK's sets; all versions stay as they were. */
  @Property(tries = 300)
  void setsAreThoseOfTheirElements(
      @ForAll @Size(max = 60) List<@IntRange(min = 0, max = 30) Integer> changes,
      @ForAll Set<@IntRange(min = 0, max = 30) Integer> others) {
    NavigableSet<Integer> model = new TreeSet<>();
    SortedSet<Integer> set = Sets.emptyset();
    for (int change : changes) {
      SortedSet<Integer> before = set;
      List<Integer> was = List.copyOf(before);
      boolean isIn = model.contains(change);
      set = isIn ? Sets.remove(change, set) : Sets.add(change, set);
      assertThat(isIn ? model.remove(change) : model.add(change)).isTrue();
      assertThat(before).containsExactlyElementsOf(was);
    }
    assertThat(set).isEqualTo(model).hasSameHashCodeAs(model).hasToString(model.toString());
    assertThat(set).containsExactlyElementsOf(model);
    for (int each : model) {
      assertThat(Sets.add(each, set)).as("one that it has").isEqualTo(model);
    }
    assertThat(Sets.of(changes)).containsExactlyElementsOf(new TreeSet<>(changes));
    SortedSet<Integer> with = Sets.of(others);
    assertThat(Sets.union(set, with)).isEqualTo(changed(model, each -> each.addAll(others)));
    assertThat(Sets.difference(set, with))
        .isEqualTo(changed(model, each -> each.removeAll(others)));
    assertThat(Sets.intersection(set, with))
        .isEqualTo(changed(model, each -> each.retainAll(others)));
    assertThat(set.headSet(9)).isEqualTo(model.headSet(9));
    assertThat(set.tailSet(9)).isEqualTo(model.tailSet(9));
    assertThat(set.subSet(3, 20)).isEqualTo(model.subSet(3, 20));
    if (model.isEmpty()) {
      assertThatThrownBy(set::first).isInstanceOf(NoSuchElementException.class);
      assertThatThrownBy(set::last).isInstanceOf(NoSuchElementException.class);
    } else {
      assertThat(set.first()).isEqualTo(model.first());
      assertThat(set.last()).isEqualTo(model.last());
    }
  }

  private static Set<Integer> changed(Set<Integer> of, Consumer<Set<Integer>> change) {
    Set<Integer> changed = new TreeSet<>(of);
    change.accept(changed);
    return changed;
  }

  @Test
  void setsAreImmutable() {
    SortedSet<String> b = Sets.singleton("b");
    SortedSet<String> both = Sets.add("a", b);
    assertThat(both).containsExactly("a", "b");
    assertThat(Sets.remove("b", both)).containsExactly("a");
    assertThat(Sets.add("b", b)).isEqualTo(b);
    assertThat(Sets.remove("c", b)).isEqualTo(b);
    assertThat(b).containsExactly("b");
    assertThat(Sets.<String>emptyset()).isEmpty();
    assertThatThrownBy(() -> both.add("c")).isInstanceOf(UnsupportedOperationException.class);
  }

  @Test
  void elementsOfSetsMayBeAnyValues() {
    Lift<String> none = new Lift.bottom<>();
    assertThat(Sets.of(List.of(new Lift.up<>("b"), none, new Lift.up<>("a"), none)))
        .containsExactly(none, new Lift.up<>("a"), new Lift.up<>("b"));
    SortedSet<List<Long>> lists = Sets.of(List.of(List.of(1L, 2L), List.of(1L), List.of(0L, 5L)));
    assertThat(lists).containsExactly(List.of(0L, 5L), List.of(1L), List.of(1L, 2L));
    SortedSet<SortedSet<String>> sets = Sets.singleton(Sets.of(List.of("b", "a")));
    assertThat(Sets.add(Sets.of(List.of("a", "b")), sets)).hasSize(1);
    Fun<String, Long> zero = Fun.always(0L);
    assertThat(Sets.of(List.of(zero.with("a", 1L), zero, zero.with("a", 0L))))
        .containsExactly(zero, zero.with("a", 1L));
  }

  @Test
  void twoSetsAreJoinedAndCompared() {
    SortedSet<String> ab = Sets.of(List.of("b", "a"));
    SortedSet<String> bc = Sets.of(List.of("b", "c"));
    assertThat(Sets.union(ab, bc)).containsExactly("a", "b", "c");
    assertThat(Sets.union(ab, Sets.emptyset())).isEqualTo(ab);
    assertThat(Sets.union(Sets.emptyset(), bc)).isEqualTo(bc);
    assertThat(Sets.difference(ab, bc)).containsExactly("a");
    assertThat(Sets.intersection(ab, bc)).containsExactly("b");
    assertThat(Sets.disjoint(ab, bc)).isFalse();
    assertThat(Sets.disjoint(ab, Sets.singleton("c"))).isTrue();
  }
}
