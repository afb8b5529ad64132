/**
 * The app for phones under test, on Robolectric where Android takes part. At the other end of its
 * Bluetooth socket stands a simulated Create, above the floor a NatNet server.
 */
package org.starl.android.app;
