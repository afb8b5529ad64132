package org.starl.comms;

/** The bytes are not a valid message. Thrown by readers, caught where datagrams arrive. */
public final class WireFormatException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  public WireFormatException(String message) {
    super(message, null, false, false);
  }
}
