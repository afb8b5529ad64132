package org.starl.id;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

class ProcessIdTest {

  /** Names with dots and digits at the end, and numbers beside those that the text leaves out. */
  @Provide
  Arbitrary<ProcessId> ids() {
    Arbitrary<String> rest = Arbitraries.strings().withChars("12._-").ofMaxLength(4);
    Arbitrary<Long> few =
        Arbitraries.of(0L, 1L, 2L, 1L << 31, 0xffff_ffffL)
            .flatMap(low -> Arbitraries.of(0L, 1L, 2L, 0x7fff_ffffL).map(high -> high << 32 | low));
    Arbitrary<Long> incs = Arbitraries.oneOf(few, Arbitraries.longs().between(1, Long.MAX_VALUE));
    return Combinators.combine(
            rest.filter(name -> RobotId.isValid("b" + name)), incs.filter(inc -> inc > 0))
        .as((name, inc) -> new ProcessId(new RobotId("b" + name), inc));
  }

  @Property
  void anIdIsReadBackFromItsText(@ForAll("ids") ProcessId id) {
    assertThat(ProcessId.parse(id.toString())).isEqualTo(id);
  }

  @Property
  void twoIdsHaveDifferentTexts(@ForAll("ids") ProcessId a, @ForAll("ids") ProcessId b) {
    assertThat(a.toString().equals(b.toString())).isEqualTo(a.equals(b));
  }

  @Example
  void theFirstIdOfTheFirstBootIsTheRobotsName() {
    RobotId bot0 = new RobotId("bot0");
    assertThat(ProcessId.first(bot0, 1)).hasToString("bot0");
    assertThat(ProcessId.first(bot0, 2)).hasToString("bot0.2");
    assertThat(new ProcessId(bot0, (1L << 32) + 3)).hasToString("bot0.1.3");
    assertThat(new ProcessId(bot0, (2L << 32) + 7)).hasToString("bot0.2.7");
  }

  @Example
  void aTextThatNoIdHasIsRefused() {
    for (String text :
        List.of(
            "",
            ".2",
            "0",
            "bot0.1",
            "bot0.02",
            "bot0.2.1",
            "bot0.2.07",
            "bot0.0.0",
            "bot0.2147483648",
            "bot0.1.4294967296",
            "bot0.9999999999.1",
            "bot0.2#3",
            "bot0#2",
            "bot0.2.3.4",
            "bot0 x")) {
      assertThatThrownBy(() -> ProcessId.parse(text))
          .as(text)
          .isInstanceOf(IllegalArgumentException.class);
    }
  }
}
