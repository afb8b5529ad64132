package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexMessage.Kind;
import org.starl.primitives.mutex.MutexMessage.Ok;
import org.starl.primitives.mutex.MutexMessage.Req;
import org.starl.primitives.mutex.MutexMessage.Wish;
import org.starl.primitives.mutex.MutexProtocol.Phase;
import org.starl.primitives.mutex.MutexProtocol.Resume;

/** Tests one participant, message by message, with modes and capacities. */
class ModesProtocolTest {

  private static final ProcessId A = id("a");
  private static final ProcessId B = id("b");
  private static final ProcessId C = id("c");
  private static final int EARLIER = 1;
  private static final int LATER = 9;

  private final List<MutexMessage> sent = new ArrayList<>();
  private final MutexNode node = new MutexNode(B, MutexProtocol::new, sent::add, fact -> {});
  private final MutexProtocol b = node.protocol;

  @Test
  void aHolderSharesItsModeAndDefersAnother() {
    holds("x/e");
    hears(asks(A, LATER, "x/e"));
    hears(asks(C, LATER, "x/w"));
    assertThat(sent).containsExactly(new Ok(B, A, 1));
  }

  @Test
  void anEarlierRequestOfAnotherModeIsNotOvertaken() {
    b.learn(View.closed(List.of(A, B, C)));
    b.request(sections("x/w"), 0);
    sent.clear();
    hears(asks(C, LATER, "x/e"));
    assertThat(sent).as("the later one waits, though it would share with a holder").isEmpty();
    hears(asks(A, EARLIER, "x/e"));
    assertThat(sent).containsExactly(new Ok(B, A, 1));
  }

  @Test
  void aHolderTellsThatItHasAPlaceUntilItReleasesIt() {
    holds("x/e*2");
    hears(asks(A, LATER, "x/e*2"));
    assertThat(sent).containsExactly(counting("x/e*2"));
    assertThat(b.open(A)).as("A may be inside").containsExactly("x/e*2");
    sent.clear();
    b.release(sections("x/e*2"));
    assertThat(sent).contains(new Ok(B, A, 1));
  }

  @Test
  void aRepeatedRequestIsToldAgainWhoHasAPlace() {
    holds("x/e*2");
    hears(asks(A, LATER, "x/e*2"));
    hears(asks(A, LATER, "x/e*2"));
    assertThat(sent).containsExactly(counting("x/e*2"), counting("x/e*2"));
  }

  @Test
  void aPlaceIsKeptWhileARequestThatHasItWaitsForMore() {
    holds("x/e*2", "y");
    hears(new Req(A, B, 1, 1, LATER, new Wish(Kind.SEQUENCE, sections("x/e*2", "y"), none())));
    sent.clear();
    Wish rest = new Wish(Kind.SEQUENCE, sections("y"), sections("x/e*2"));
    hears(new Req(A, B, 1, 1, LATER, rest));
    assertThat(sent).isEmpty();
    hears(new Req(A, B, 1, 1, LATER, rest));
    assertThat(sent).containsExactly(counting("x/e*2"));
  }

  @Test
  void consentToTheRestIsToldBesideAPlace() {
    holds("x/e*2", "y");
    hears(new Req(A, B, 1, 1, LATER, new Wish(Kind.SEQUENCE, sections("x/e*2", "y"), none())));
    hears(new Req(A, B, 1, 1, LATER, new Wish(Kind.SEQUENCE, sections("y"), sections("x/e*2"))));
    sent.clear();
    b.release(sections("y"));
    assertThat(sent).contains(new Ok(B, A, 1)).noneMatch(counting("x/e*2")::equals);
  }

  @Test
  void oneOfTwoPlacesIsEnough() {
    b.learn(View.closed(List.of(A, B, C)));
    b.request(sections("x/e*2"), 0);
    hears(new Ok(A, B, 1, none(), sections("x/e*2")));
    assertThat(b.held()).as("C has not answered").isEmpty();
    hears(new Ok(C, B, 1, none(), sections("x/e*2")));
    assertThat(b.held()).as("both places are taken").isEmpty();
    hears(new Ok(A, B, 1));
    assertThat(b.held()).containsExactly("x/e*2");
  }

  @Test
  void aGhostHasAPlace() {
    TreeMap<ProcessId, Long> admitted = new TreeMap<>();
    admitted.put(A, 1L);
    admitted.put(B, 1L);
    TreeMap<ProcessId, View.Ghost> ghosts = new TreeMap<>();
    ghosts.put(C, new View.Ghost(1, sections("x/e*2")));
    b.learn(new View(2, admitted, ghosts));
    b.request(sections("x/e*2"), 0);
    hears(new Ok(A, B, 1, none(), sections("x/e*2")));
    assertThat(b.held()).isEmpty();
    hears(new Ok(A, B, 1));
    assertThat(b.held()).containsExactly("x/e*2");
  }

  @Test
  void aPlaceOfAnotherProcessOfTheSameRobotDoesNotCount() {
    ProcessId other = new ProcessId(B.robot(), B.inc() + 1);
    b.learn(View.closed(List.of(A, B, other)));
    b.request(sections("x/e*2"), 0);
    hears(new Ok(A, B, 1, none(), sections("x/e*2")));
    hears(new Ok(other, B, 1, none(), sections("x/e*2")));
    assertThat(b.held()).containsExactly("x/e*2");
  }

  @Test
  void aNewcomerWithAnEarlierTimeWaitsForAHolderThatHasNotCountedIt() {
    holds("x/e*2");
    hears(asks(id("d"), 0, "x/e*2"));
    assertThat(sent).isEmpty();
  }

  @Test
  void aResumedRobotIsLetInWhereItsBodyIs() {
    holds("x/e*2", "y");
    Wish inside = new Wish(Kind.RESUMED, sections("x/e*2"), sections("x/e*2"));
    hears(new Req(A, B, 1, 1, LATER, inside));
    hears(new Req(C, B, 1, 1, LATER, new Wish(Kind.RESUMED, sections("x/e*2"), none())));
    assertThat(sent).containsExactly(new Ok(B, A, 1), new Ok(B, C, 1, none(), sections("x/e*2")));
  }

  @Test
  void twoResumedRobotsWithBodiesInOneSectionDoNotWaitForEachOther() {
    b.takeOver(new Resume(sections("x/e*2"), sections("x/e*2", "y")));
    b.learn(View.closed(List.of(A, B)));
    b.request(List.of("x/e*2", "y"), true, 0);
    assertThat(sent)
        .hasSize(1)
        .first()
        .extracting(m -> ((Req) m).isInside("x/e*2"))
        .isEqualTo(true);
    sent.clear();
    Wish inside = new Wish(Kind.RESUMED, sections("x/e*2"), sections("x/e*2"));
    hears(new Req(A, B, 1, 1, LATER, inside));
    assertThat(sent).containsExactly(new Ok(B, A, 1));
    hears(new Ok(A, B, 1));
    assertThat(b.phase()).isEqualTo(Phase.CRITICAL);
  }

  @Test
  void aResumedRobotTellsThatItsBodyHasAPlace() {
    b.takeOver(new Resume(sections("x/e*2"), sections("x/e*2", "y")));
    b.learn(View.closed(List.of(A, B)));
    b.request(List.of("x/e*2", "y"), true, 0);
    sent.clear();
    Wish ahead = new Wish(Kind.RESUMED, sections("x/e*2"), none());
    hears(new Req(A, B, 1, 1, LATER, ahead));
    assertThat(sent).containsExactly(counting("x/e*2"));
  }

  @Test
  void aClaimIsKeptBesideABodyOfItsModeAndNotBesideAnother() {
    b.takeOver(new Resume(sections("y"), sections("x/e*2", "y")));
    b.learn(View.closed(List.of(A, B)));
    Wish inside = new Wish(Kind.RESUMED, sections("x/e*2"), sections("x/e*2"));
    hears(new Req(A, B, 1, 1, LATER, inside));
    assertThat(b.kept()).containsExactly("x/e*2", "y");
    Wish opposite = new Wish(Kind.RESUMED, sections("x/w*2"), sections("x/w*2"));
    hears(new Req(C, B, 1, 1, LATER, opposite));
    assertThat(b.kept()).containsExactly("y");
  }

  private static ProcessId id(String name) {
    return ProcessId.first(new RobotId(name), 1);
  }

  private static SortedSet<String> sections(String... names) {
    return Sections.copyOf(List.of(names));
  }

  private static SortedSet<String> none() {
    return Sections.NONE;
  }

  private static Req asks(ProcessId from, int ts, String sections) {
    return new Req(from, B, 1, 1, ts, sections(sections));
  }

  /** The answer to A that counts B itself. */
  private static Ok counting(String sections) {
    return new Ok(B, A, 1, none(), sections(sections));
  }

  private void hears(MutexMessage message) {
    b.receive(message, 0);
  }

  /** It holds these, at logical time 1, with the consent of A and C. */
  private void holds(String... sections) {
    b.learn(View.closed(List.of(A, B, C)));
    b.request(List.of(sections), sections.length > 1, 0);
    hears(new Ok(A, B, 1));
    hears(new Ok(C, B, 1));
    assertThat(b.phase()).isEqualTo(Phase.CRITICAL);
    sent.clear();
  }
}
