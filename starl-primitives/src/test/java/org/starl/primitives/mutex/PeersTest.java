package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.mutex.MutexMessage.Rem;
import org.starl.primitives.mutex.MutexMessage.Req;

/** Messages of a peer's request that come late, or twice. */
class PeersTest {

  private static final ProcessId ME = ProcessId.first(new RobotId("me"), 1);
  private static final ProcessId PEER = ProcessId.first(new RobotId("peer"), 1);
  private static final SortedSet<String> BOTH = new TreeSet<>(List.of("x", "y"));

  @Test
  void aLateNoticeOfAPartDoesNotOpenARequestThatIsOver() {
    Peers peers = new Peers();
    Req request = new Req(PEER, ME, 1, 1, 1, BOTH);
    assertThat(peers.hear(request)).isNotNull();
    peers.hearRem(new Rem(PEER, ME, 1, Sections.NONE));
    peers.hearRem(new Rem(PEER, ME, 1, new TreeSet<>(List.of("x"))));
    assertThat(peers.hear(request)).as("a copy of the request").isNull();
    assertThat(peers.open(PEER)).isEmpty();
  }

  @Test
  void aNewRequestReplacesADeferredOne() {
    Peers peers = new Peers();
    Req request = new Req(PEER, ME, 1, 1, 1, BOTH);
    peers.hear(request);
    peers.defer(request);
    assertThat(peers.pending()).containsExactly(request);
    peers.hear(new Req(PEER, ME, 2, 1, 2, BOTH));
    assertThat(peers.pending()).isEmpty();
  }
}
