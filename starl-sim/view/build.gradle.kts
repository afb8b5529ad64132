plugins {
    `java-library`
    id("maven-publish")
}

description = "Window, pictures, replay and export of simulated runs"

dependencies {
    api(project(":starl-core"))
    api(project(":starl-core-input"))
    api(project(":starl-sim"))
    api(libs.jspecify)
    implementation(libs.jackson.databind)
    implementation(libs.flatlaf)
    implementation(libs.jcodec)
    implementation(libs.xmlgraphics.commons)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}

// The driver of a browser, which the server's pages are tested with, too.
extensions.configure<JavaPluginExtension> {
    sourceSets.named("test") { java.srcDir("src/browser/java") }
}
