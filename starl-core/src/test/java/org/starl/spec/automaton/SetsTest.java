package org.starl.spec.automaton;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

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
}
