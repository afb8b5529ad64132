package org.starl.comms;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.shape.Shapes;

/** Which names a channel may have, and what a reliable message may be sent with. */
class ChannelTest {

  private static final String LONGEST = "abcdefghijklmnopqrstuvwxyz_-.09";

  @ParameterizedTest
  @ValueSource(strings = {LONGEST, "AMZ", "azAZ09", ".", "-", "_"})
  void aNameIsOfLettersDigitsAndThreeSigns(String part) {
    assertThat(new Channel<>(part, part, Shapes.TEXT).name()).isEqualTo(part + "/" + part);
    assertThat(Channel.isName(part + "/" + part)).isTrue();
  }

  /** The characters right before and after the ranges, and a name that is too long. */
  @ParameterizedTest
  @ValueSource(strings = {"", "`", "{", "@", "[", "/", ":", "\u00e4", LONGEST + "x"})
  void anyOtherNameIsRefused(String part) {
    assertThatIllegalArgumentException().isThrownBy(() -> new Channel<>(part, "x", Shapes.TEXT));
    assertThatIllegalArgumentException().isThrownBy(() -> new Channel<>("x", part, Shapes.TEXT));
    assertThat(Channel.isName(part + "/x")).isFalse();
    assertThat(Channel.isName("x/" + part)).isFalse();
  }

  @Test
  void aNameHasTwoParts() {
    assertThat(Channel.isName("x")).isFalse();
  }

  @Test
  void reliabilityAtItsLimitsIsTakenAndBeyondThemRefused() {
    assertThat(new Reliability(1, 1, 1, 0, 1).maxRetries()).isZero();
    assertThatIllegalArgumentException().isThrownBy(() -> new Reliability(0, 1, 1, 0, 1));
    assertThatIllegalArgumentException().isThrownBy(() -> new Reliability(1, 0.9, 1, 0, 1));
    assertThatIllegalArgumentException().isThrownBy(() -> new Reliability(1, Double.NaN, 1, 0, 1));
    assertThatIllegalArgumentException().isThrownBy(() -> new Reliability(2, 1, 1, 0, 1));
    assertThatIllegalArgumentException().isThrownBy(() -> new Reliability(1, 1, 1, -1, 1));
    assertThatIllegalArgumentException().isThrownBy(() -> new Reliability(1, 1, 1, 0, 0));
  }
}
