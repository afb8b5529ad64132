package org.starl.primitives.membership;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Names of sections, with modes and capacities, and which of them robots have together. */
class SectionsTest {

  private static final List<String> NAMES =
      List.of("A", "A/e", "A/w", "A/e*1", "A/e*2", "A/e*3", "AA", "AA/e", "B/e*2");

  @ParameterizedTest
  @CsvSource({
    "A,     A,     true,  true",
    "A,     B,     false, false",
    "A,     AA,    false, false",
    "A,     A/e,   true,  true",
    "A/e,   A/w,   true,  true",
    "A/e,   A/e,   false, false",
    "A/e*2, A/e*2, false, true",
    "A/e*1, A/e*1, true,  true",
    "A/e*2, A/e*3, true,  true",
    "A/e*2, A/e,   true,  true",
    "A/e*2, B/w*2, false, false",
  })
  void oneSectionIsSharedInOneModeOnly(String a, String b, boolean exclude, boolean compete) {
    assertThat(Sections.exclude(a, b)).isEqualTo(exclude);
    assertThat(Sections.compete(a, b)).isEqualTo(compete);
  }

  @Property
  void theRelationsAreSymmetricAndOneIsInTheOther(
      @ForAll @IntRange(max = 8) int i, @ForAll @IntRange(max = 8) int j) {
    String a = NAMES.get(i);
    String b = NAMES.get(j);
    assertThat(Sections.exclude(a, b)).isEqualTo(Sections.exclude(b, a));
    assertThat(Sections.compete(a, b)).isEqualTo(Sections.compete(b, a));
    assertThat(Sections.compete(a, b) || !Sections.exclude(a, b)).isTrue();
    assertThat(Sections.exclude(a, a)).isEqualTo(Sections.capacity(a) == 1);
  }

  @ParameterizedTest
  @CsvSource({"A, 1, A", "A/e, 2147483647, A", "A/e*2, 2, A", "lane.1/north-2*999, 999, lane.1"})
  void aNameHasASectionAndACapacity(String name, int capacity, String place) {
    assertThat(Sections.copyOf(List.of(name))).containsExactly(name);
    assertThat(Sections.capacity(name)).isEqualTo(capacity);
    assertThat(Sections.place(name)).isEqualTo(place);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "/",
        "A/",
        "/e",
        "A/e/w",
        "A*2",
        "A/*2",
        "A/e*",
        "A/e*0",
        "A/e*02",
        "A/e*1000",
        "A/e*2*2",
        "A/e*-1",
        "A b",
        "A/e*x"
      })
  void anotherTextIsNoName(String name) {
    assertThatThrownBy(() -> Sections.copyOf(List.of(name)))
        .hasMessageContaining("section '" + name + "': expected");
  }

  @Test
  void aNameWithItsModeHas32LettersAtMost() {
    String longest = "A".repeat(28) + "/e*2";
    assertThat(Sections.copyOf(List.of(longest))).hasSize(1);
    assertThatThrownBy(() -> Sections.copyOf(List.of("A" + longest)))
        .hasMessageContaining("expected 1 to 32");
  }
}
