package org.starl.comms;

/** A pending reliable message: the datagram to retransmit, and what the trace records. */
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
