package org.starl.primitives.agreement;

import org.jspecify.annotations.Nullable;
import org.starl.gvh.Wait;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.trace.Instance;

/**
 * One robot's part in a primitive that decides by a {@link Synod}: the base of the protocols of
 * agreement, registration, election and barrier. Pure and clock-driven: calls, messages and timers
 * in, effects out; times are now, in ns. {@link #timer} is due at {@link #wakeAtNs}, which every call
 * may change.
 */
public abstract class SynodProtocol implements SynodListener {

  /** The due time of a timer that is not set. */
  protected static final long NEVER = Long.MAX_VALUE;

  protected final Synod synod;

  /** The time of the present input. */
  protected long nowNs;

  /** Creates the {@link Synod} with these parameters, and listens to it. */
  @SuppressWarnings("this-escape") // the Synod calls its listener only during later calls
  protected SynodProtocol(
      RobotId self,
      Participants acceptors,
      ProcessId proposerId,
      SynodTiming timing,
      Rng rng,
      SynodLink link,
      long nowNs) {
    this.nowNs = nowNs;
    synod = new Synod(self, acceptors, proposerId, timing, rng, link, this);
  }

  /** Receives a message of the Synod. */
  public void received(RobotId from, SynodMessage message, long now) {
    nowNs = now;
    synod.received(from, message, now);
  }

  /** As {@link Synod#flushed}. */
  public final void flushed(long version, long now) {
    nowNs = now;
    synod.flushed(version);
  }

  public final void timer(long now) {
    nowNs = now;
    synod.timer(now);
    ownTimers();
  }

  /** When {@link #timer} is due; {@link #NEVER} if no timer is set. */
  public final long wakeAtNs() {
    return Math.min(synod.wakeAtNs(), ownWakeAtNs());
  }

  /** What it waits for, in words, and from which robots; null if for nothing. */
  public @Nullable Wait waitsFor(Instance source) {
    return synod.isProposing()
        ? new Wait(source, "needs answers of a majority; missing", synod.unanswered())
        : null;
  }

  /** Does what is due by {@link #nowNs}, beside the Synod's own work; perhaps nothing. */
  protected abstract void ownTimers();

  /** When {@link #ownTimers} has work to do. */
  protected abstract long ownWakeAtNs();
}
