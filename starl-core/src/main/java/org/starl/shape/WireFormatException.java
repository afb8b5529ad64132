package org.starl.shape;

import java.util.regex.Pattern;

/** The bytes are not a valid message. Thrown by readers, caught where datagrams arrive. */
public final class WireFormatException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  // A message quotes what came from outside, and logs have one line for each.
  private static final Pattern BREAKS = Pattern.compile("[\\p{Cntrl}\\u0085\\u2028\\u2029]");

  public WireFormatException(String message) {
    super(BREAKS.matcher(message).replaceAll("?"), null, false, false);
  }
}
