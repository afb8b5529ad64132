package org.starl.spec.automaton;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.SortedSet;
import org.junit.jupiter.api.Test;

class SetsTest {

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
