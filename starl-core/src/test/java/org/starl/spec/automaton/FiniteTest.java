package org.starl.spec.automaton;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class FiniteTest {

  private static final List<Integer> SOME = List.of(1, 2);
  private static final List<Integer> MORE = List.of(2, 3);

  @Test
  void conditionsAreEvaluatedAtAllElements() {
    assertThat(Finite.forAll(x -> x < 4, SOME, MORE)).isTrue();
    assertThat(Finite.forAll(x -> x < 3, SOME, MORE)).isFalse();
    assertThat(Finite.exists(x -> x == 3, SOME, MORE)).isTrue();
    assertThat(Finite.exists(x -> x == 4, SOME, MORE)).isFalse();
    assertThat(Finite.suchThat(x -> x > 1, SOME, MORE)).containsExactly(2, 3);
    assertThat(Finite.first(x -> x > 1, x -> "x = " + x, SOME, MORE)).isEqualTo("x = 2");
    assertThat(Finite.first(x -> x > 9, x -> "x = " + x, SOME, MORE)).isEmpty();
  }

  @Test
  void mapsAreTheOtherOneElsewhere() {
    Fun<Integer, Boolean> odd = Finite.map(Fun.always(false), x -> x % 2 == 1, SOME, MORE);
    assertThat(odd).isEqualTo(Fun.<Integer, Boolean>always(false).with(1, true).with(3, true));
    assertThat(odd.arguments()).containsExactly(1, 3);
    Fun<Integer, Boolean> some = Fun.<Integer, Boolean>always(false).with(2, true).with(4, true);
    assertThat(Finite.map(some, x -> x % 2 == 1, SOME, MORE).arguments()).containsExactly(1, 3, 4);
    assertThat(Finite.map(some, some::at, SOME, MORE)).isSameAs(some);
  }
}
