package org.starl.apps.lineup.logic

/** The value that robots propose: whole millimetres as four bytes, highest first. */
internal object Millimetres {

  private const val BYTES = 4

  fun bytes(mm: Double): ByteArray {
    val whole = Math.round(mm).toInt()
    return ByteArray(BYTES) { i -> (whole shr (8 * (BYTES - 1 - i))).toByte() }
  }

  fun of(bytes: ByteArray): Double {
    require(bytes.size == BYTES) { "${bytes.size} bytes: expected $BYTES" }
    return bytes.fold(0) { whole, byte -> (whole shl 8) or (byte.toInt() and 0xFF) }.toDouble()
  }
}
