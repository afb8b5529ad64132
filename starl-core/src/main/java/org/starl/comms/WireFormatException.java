package org.starl.comms;

/** Bytes that are no message. Thrown by readers, caught where datagrams arrive. */
public final class WireFormatException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  public WireFormatException(String message) {
    super(message, null, false, false);
  }
}
