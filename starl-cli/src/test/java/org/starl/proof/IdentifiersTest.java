package org.starl.proof;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;

class IdentifiersTest {

  private final Identifiers identifiers = new Identifiers();

  @ParameterizedTest
  @CsvSource({
    "bot0, bot0",
    "A, A",
    "bot-1, bot_1",
    "a.b:c, a_b_c",
    "7, n7",
    "_x, n_x",
    "or, n_or", // words of the language, in small letters or capitals
    "all, n_all",
    "Ghost, n_Ghost",
    "O, n_O",
    "s_1, n_s_1", // names that the theory has for itself
    "step_3, n_step_3",
    "x, n_x",
    "emptyset, n_emptyset"
  })
  void aNameIsCloseToTheThingsOwn(String thing, String name) {
    assertThat(identifiers.of(thing)).isEqualTo(name).matches("[A-Za-z][A-Za-z0-9_]*");
    assertThat(identifiers.of(thing)).isEqualTo(name);
  }

  @Test
  void noTwoThingsShareAName() {
    identifiers.reserve("PIDS");
    List<Object> things =
        List.of("a-b", "a.b", "a_b", new RobotId("a_b"), "a_b_2", "PIDS", new RobotId("PIDS"));
    assertThat(things.stream().map(identifiers::of).toList())
        .containsExactly("a_b", "a_b_2", "a_b_3", "a_b_4", "a_b_2_2", "PIDS_2", "PIDS_3");
  }

  @Test
  void anIdHasTheNameOfItsText() {
    RobotId bot = new RobotId("bot-1");
    assertThat(identifiers.of(ProcessId.first(bot, 3))).isEqualTo("bot_1_3");
    assertThat(identifiers.of(new ProcessId(bot, (2L << 32) + 5))).isEqualTo("bot_1_2_5");
  }
}
