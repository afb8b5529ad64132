package org.starl.id;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.math.BigInteger;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

class RobotIdTest {

  /** Few letters, so that names often agree up to a number, and numbers up to zeros before them. */
  @Provide
  Arbitrary<RobotId> ids() {
    Arbitrary<String> rest = Arbitraries.strings().withChars("a019-").ofMaxLength(6);
    return rest.map(text -> new RobotId("b" + text));
  }

  @Property
  void theOrderIsTotal(
      @ForAll("ids") RobotId a, @ForAll("ids") RobotId b, @ForAll("ids") RobotId c) {
    assertThat(Integer.signum(a.compareTo(b))).isEqualTo(-Integer.signum(b.compareTo(a)));
    assertThat(a.compareTo(b) == 0).isEqualTo(a.equals(b));
    if (a.compareTo(b) <= 0 && b.compareTo(c) <= 0) {
      assertThat(a.compareTo(c)).isLessThanOrEqualTo(0);
    }
  }

  @Property
  void numbersAreComparedByValue(@ForAll("ids") RobotId a, @ForAll("ids") RobotId b) {
    List<Object> parts = parts(a);
    List<Object> others = parts(b);
    int same = 0;
    while (same < parts.size()
        && same < others.size()
        && parts.get(same).equals(others.get(same))) {
      same++;
    }
    if (same < parts.size()
        && same < others.size()
        && parts.get(same) instanceof BigInteger number
        && others.get(same) instanceof BigInteger other) {
      assertThat(Integer.signum(a.compareTo(b))).isEqualTo(number.compareTo(other));
    }
  }

  @Example
  void equalNumbersAreOrderedByLeadingZeros() {
    assertThat(new RobotId("bot01").compareTo(new RobotId("bot1"))).isNegative();
    assertThat(new RobotId("bot1a").compareTo(new RobotId("bot01b"))).isNegative();
  }

  @Example
  void longNamesWithNumbersAreOrderedByTheirLettersFirst() {
    assertThat(new RobotId("abcdefghi2").compareTo(new RobotId("bbcdefghi1"))).isNegative();
    assertThat(new RobotId("abcdefghi2").compareTo(new RobotId("abcdefghi10"))).isNegative();
    assertThat(new RobotId("abcdefgh2").compareTo(new RobotId("abcdefgh10"))).isNegative();
  }

  @Example
  void invalidNamesAreRefused() {
    for (String bad : List.of("", "1bot", "-", "b b", "bät", "b".repeat(33), "bot0.2", "a.b.10")) {
      assertThatThrownBy(() -> new RobotId(bad)).hasMessageContaining("'" + bad + "'");
    }
  }

  /** A name's numbers as numbers, and what stands between them. */
  private static List<Object> parts(RobotId id) {
    return Pattern.compile("\\d+|\\D+")
        .matcher(id.name())
        .results()
        .map(MatchResult::group)
        .map(text -> Character.isDigit(text.charAt(0)) ? new BigInteger(text) : (Object) text)
        .toList();
  }
}
