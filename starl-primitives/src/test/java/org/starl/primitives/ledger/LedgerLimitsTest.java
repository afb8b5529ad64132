package org.starl.primitives.ledger;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.starl.primitives.agreement.SynodTiming;
import org.starl.primitives.agreement.Value;

/** The last value that is taken, and the first that is refused. */
class LedgerLimitsTest {

  @Test
  void aTaskHasANameOfASourceAndANumberFromOne() {
    String longest = "x".repeat(31);
    assertThat(new TaskId(longest, 1).number()).isEqualTo(1);
    assertThatIllegalArgumentException().isThrownBy(() -> new TaskId(longest + "x", 1));
    assertThatIllegalArgumentException().isThrownBy(() -> new TaskId("", 1));
    assertThatIllegalArgumentException().isThrownBy(() -> new TaskId("x", 0));
  }

  @Test
  void aLeaseIsLongerThanABeacon() {
    SynodTiming timing = SynodTiming.DEFAULT;
    assertThat(new LedgerSettings(timing, 1, 2, 1).leaseMs()).isEqualTo(2);
    assertThatIllegalArgumentException().isThrownBy(() -> new LedgerSettings(timing, 0, 2, 1));
    assertThatIllegalArgumentException().isThrownBy(() -> new LedgerSettings(timing, 2, 2, 1));
    assertThatIllegalArgumentException().isThrownBy(() -> new LedgerSettings(timing, 1, 2, 0));
  }

  @Test
  void aPartIsOneOfItsCount() {
    assertThat(new LedgerMessage.Part(Seen.PA, 1, 1, 2, Value.EMPTY).index()).isEqualTo(1);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new LedgerMessage.Part(Seen.PA, 1, 2, 2, Value.EMPTY));
  }
}
