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
