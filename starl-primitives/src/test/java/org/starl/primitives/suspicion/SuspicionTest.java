package org.starl.primitives.suspicion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;

class SuspicionTest {

  private static final long SILENCE_NS = 100;
  private static final ProcessId A = ProcessId.first(new RobotId("bot2"), 1);
  private static final ProcessId B = ProcessId.first(new RobotId("bot10"), 1);
  private static final ProcessId A_AGAIN = ProcessId.first(new RobotId("bot2"), 2);

  private final Suspicion suspicion = new Suspicion(SILENCE_NS);

  @Test
  void aParticipantThatIsNotNeededIsNeverSuspected() {
    suspicion.heard(A, 5);
    assertThat(suspicion.suspects(A, 1_000_000)).isFalse();
    assertThat(suspicion.suspects(1_000_000)).isEmpty();
    assertThat(suspicion.wakeAtNs(0)).isEqualTo(Long.MAX_VALUE);
  }

  @Test
  void silenceCountsFromTheFirstNeed() {
    suspicion.expect(A, 50);
    suspicion.expect(A, 120);
    assertThat(suspicion.suspects(A, 149)).isFalse();
    assertThat(suspicion.suspects(A, 150)).isTrue();
  }

  @Test
  void anyMessageRestartsTheSilenceAndEndsASuspicion() {
    suspicion.expect(A, 0);
    assertThat(suspicion.suspects(A, 130)).isTrue();
    suspicion.heard(A, 130);
    assertThat(suspicion.suspects(A, 130)).isFalse();
    assertThat(suspicion.suspects(A, 229)).isFalse();
    assertThat(suspicion.suspects(A, 230)).isTrue();
  }

  @Test
  void aReleasedParticipantIsSuspectedOnlyWhenNeededAgain() {
    suspicion.expect(A, 0);
    suspicion.release(A);
    assertThat(suspicion.suspects(A, 500)).isFalse();
    suspicion.expect(A, 500);
    assertThat(suspicion.suspects(A, 599)).isFalse();
    assertThat(suspicion.suspects(A, 600)).isTrue();
  }

  @Test
  void aRestartedRobotIsAnotherParticipant() {
    suspicion.expect(A, 0);
    suspicion.heard(A_AGAIN, 90);
    assertThat(suspicion.suspects(A, 100)).isTrue();
    assertThat(suspicion.suspects(A_AGAIN, 100)).isFalse();
  }

  @Test
  void suspectsComeInTheOrderOfTheirNames() {
    suspicion.expect(B, 0);
    suspicion.expect(A_AGAIN, 1);
    suspicion.expect(A, 2);
    assertThat(suspicion.suspects(101)).containsExactly(A_AGAIN, B);
    assertThat(suspicion.suspects(102)).containsExactly(A, A_AGAIN, B);
    assertThat(suspicion.expected()).containsExactly(A, A_AGAIN, B);
  }

  @Test
  void theWakeTimeIsTheNextSuspicion() {
    suspicion.expect(A, 0);
    suspicion.expect(B, 30);
    assertThat(suspicion.wakeAtNs(0)).isEqualTo(100);
    assertThat(suspicion.wakeAtNs(99)).isEqualTo(100);
    assertThat(suspicion.wakeAtNs(100)).isEqualTo(130);
    assertThat(suspicion.wakeAtNs(130)).isEqualTo(Long.MAX_VALUE);
  }

  @Test
  void aSilenceOfZeroIsRefused() {
    assertThatThrownBy(() -> new Suspicion(0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("above 0");
  }

  /** By the definition: needed since, nothing heard since, and the time is up. */
  @Property(tries = 300)
  void aParticipantIsSuspectedExactlyAfterItsSilence(
      @ForAll @Size(max = 60) List<@IntRange(min = 0, max = 399) Integer> steps) {
    Suspicion tried = new Suspicion(SILENCE_NS);
    List<String> history = new ArrayList<>();
    long nowNs = 0;
    for (int step : steps) {
      // Each step: what happens (3 kinds, or nothing), and how much later.
      nowNs += step / 4;
      history.add(step % 4 + "@" + nowNs);
      switch (step % 4) {
        case 0 -> tried.expect(A, nowNs);
        case 1 -> tried.heard(A, nowNs);
        case 2 -> tried.release(A);
        default -> tried.heard(B, nowNs);
      }
      long sinceNs = silentSinceNs(history);
      boolean expected = sinceNs >= 0 && nowNs - sinceNs >= SILENCE_NS;
      assertThat(tried.suspects(A, nowNs)).as("%s", history).isEqualTo(expected);
      assertThat(tried.suspects(nowNs)).isEqualTo(expected ? List.of(A) : List.of());
      assertThat(tried.wakeAtNs(nowNs))
          .isEqualTo(sinceNs < 0 || expected ? Long.MAX_VALUE : sinceNs + SILENCE_NS);
    }
  }

  /** Read backwards: the last word or first need since the last release; -1 if not needed. */
  private static long silentSinceNs(List<String> history) {
    int lastRelease = -1;
    int firstNeed = -1;
    int lastWord = -1;
    for (int i = 0; i < history.size(); i++) {
      char kind = history.get(i).charAt(0);
      if (kind == '2') {
        lastRelease = i;
        firstNeed = -1;
      } else if (kind == '0' && firstNeed < 0) {
        firstNeed = i;
      } else if (kind == '1') {
        lastWord = i;
      }
    }
    if (firstNeed <= lastRelease) {
      return -1;
    }
    String since = history.get(Math.max(firstNeed, lastWord));
    return Long.parseLong(since.substring(since.indexOf('@') + 1));
  }
}
