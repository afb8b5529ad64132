package org.starl.primitives.chaos;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodLink;
import org.starl.primitives.agreement.SynodMessage;

/** The world of one robot alone: keeps what it sends, and its latest record. */
public final class SentMessages implements SynodLink {

  private final List<Object> sent = new ArrayList<>();
  private byte @Nullable [] record;

  /** The messages since the last call of this, in order. */
  public List<Object> take() {
    List<Object> taken = List.copyOf(sent);
    sent.clear();
    return taken;
  }

  /** A message of the primitive itself. */
  public void add(Object message) {
    sent.add(message);
  }

  @Override
  public byte @Nullable [] record() {
    return record;
  }

  @Override
  public void send(RobotId to, SynodMessage message) {
    sent.add(message);
  }

  @Override
  public void persist(long version, byte[] written) {
    record = written;
  }
}
