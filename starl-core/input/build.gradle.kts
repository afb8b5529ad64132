plugins {
    `java-library`
    id("maven-publish")
}

description = "Reads what people write: quantities, text files"

dependencies {
    api(libs.jspecify)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}
