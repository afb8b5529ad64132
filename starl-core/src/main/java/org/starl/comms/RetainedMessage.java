package org.starl.comms;

/** A reliable message under way: what is transmitted again, and what the trace tells of it. */
final class RetainedMessage {

  final OpenEndpoint<?> endpoint;
  final Object message;
  final long number;
  final byte[] datagram;

  RetainedMessage(OpenEndpoint<?> endpoint, Object message, long number, byte[] datagram) {
    this.endpoint = endpoint;
    this.message = message;
    this.number = number;
    this.datagram = datagram;
  }
}
