package org.starl.comms;

import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;

/** An endpoint of {@link Comms}. */
final class OpenEndpoint<T> implements Endpoint<T> {

  final Channel<T> channel;
  final byte[] name;
  final Handler<T> handler;

  /** The next one in the robot's list of open endpoints. */
  @Nullable OpenEndpoint<?> next;

  private final Comms comms;
  private boolean isOpen = true;

  OpenEndpoint(Comms comms, Channel<T> channel, Handler<T> handler) {
    this.comms = comms;
    this.channel = channel;
    this.name = channel.wireName;
    this.handler = handler;
  }

  @Override
  public void send(RobotId to, T message) {
    checkOpen();
    comms.send(this, to, message);
  }

  @Override
  public void broadcast(T message) {
    checkOpen();
    comms.send(this, null, message);
  }

  @Override
  public Receipt sendReliably(RobotId to, T message) {
    return sendReliably(to, message, Reliability.DEFAULT);
  }

  @Override
  public Receipt sendReliably(RobotId to, T message, Reliability reliability) {
    checkOpen();
    return comms.sendReliably(this, to, message, reliability);
  }

  @Override
  public void close() {
    if (isOpen) {
      isOpen = false;
      comms.close(this);
    }
  }

  private void checkOpen() {
    if (!isOpen) {
      throw new IllegalStateException("channel " + channel.name() + " is closed");
    }
  }
}
